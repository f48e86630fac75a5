// SPDX-License-Identifier: MIT
#include "robot/core/tcp_connect.h"

namespace tiller {

namespace {

using native_socket::Descriptor;

Error expired(const Deadline& deadline, const QString& context) {
    return {deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, context,
            QStringLiteral("no response in time")};
}

Error refusal(int error, const QString& context) {
    return {native_socket::isRefusal(error) ? ErrorCode::ConnectionRefused : ErrorCode::HostUnreachable,
            context, qt_error_string(error)};
}

Result<Descriptor> connectTo(const native_socket::Address& address, const Deadline& deadline,
                             const QString& context) {
    const native_socket::Attempt attempt = native_socket::connect(address);
    if (attempt.socket < 0) {
        return Error{ErrorCode::Internal, context, QStringLiteral("too many files and sockets are open")};
    }
    const auto fail = [&](const Error& error) {
        native_socket::close(attempt.socket);
        return error;
    };
    int error = attempt.error;
    if (attempt.isPending) {
        while (!native_socket::waitWritable(attempt.socket, deadline.nextPoll())) {
            if (deadline.hasExpired()) {
                return fail(expired(deadline, context));
            }
        }
        error = native_socket::connectError(attempt.socket);
    }
    if (error != 0) {
        return fail(refusal(error, context));
    }
    native_socket::prepare(attempt.socket);
    native_socket::watchPeer(attempt.socket);
    return attempt.socket;
}

}  // namespace

Result<Descriptor> connectTcp(const QString& host, int port, const Deadline& deadline, QString context) {
    const QString name = host.trimmed();
    if (context.isEmpty()) {
        context = QStringLiteral("connect to %1:%2").arg(name).arg(port);
    }
    constexpr int kMaxPort = 65535;
    if (name.isEmpty() || port <= 0 || port > kMaxPort) {
        return Error{ErrorCode::AddressInvalid, context,
                     name.isEmpty() ? QStringLiteral("the address is empty")
                                    : QStringLiteral("port %1 is outside the range 1 to 65535").arg(port)};
    }
    if (!native_socket::startUp()) {
        return Error{ErrorCode::Internal, context,
                     QStringLiteral("sockets are not available on this system")};
    }
    const std::vector<native_socket::Address> addresses = native_socket::resolve(name.toStdString(), port);
    if (addresses.empty()) {
        return Error{ErrorCode::AddressInvalid, context, QStringLiteral("Host not found")};
    }
    Error last;
    for (const native_socket::Address& address : addresses) {
        auto connected = connectTo(address, deadline, context);
        if (connected || deadline.hasExpired()) {
            return connected;
        }
        last = connected.error();
    }
    return last;
}

}  // namespace tiller
