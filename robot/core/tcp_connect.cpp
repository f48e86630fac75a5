// SPDX-License-Identifier: MIT
#include "robot/core/tcp_connect.h"

#include <memory>

#ifdef _WIN32
#include <winsock2.h>
#include <ws2tcpip.h>
#else
#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#endif

namespace tiller {

namespace {

using native_socket::Descriptor;

#ifdef _WIN32
// Written from the Winsock documentation; not run in the project's CI.
using Handle = SOCKET;
constexpr int kRefused = WSAECONNREFUSED;
constexpr int kConnectPending = WSAEWOULDBLOCK;

int lastError() {
    return WSAGetLastError();
}
QString textOf(int error) {
    return QStringLiteral("Winsock error %1").arg(error);
}
bool startUp() {
    static const bool started = [] {
        WSADATA data;
        return WSAStartup(MAKEWORD(2, 2), &data) == 0;
    }();
    return started;
}
void makeNonBlocking(Handle socket) {
    u_long on = 1;
    ioctlsocket(socket, FIONBIO, &on);
}
int waitWritable(Handle socket, std::chrono::milliseconds atMost) {
    WSAPOLLFD item{socket, POLLWRNORM, 0};
    return WSAPoll(&item, 1, static_cast<int>(atMost.count()));
}
#else
using Handle = int;
constexpr int kRefused = ECONNREFUSED;
constexpr int kConnectPending = EINPROGRESS;

int lastError() {
    return errno;
}
QString textOf(int error) {
    return qt_error_string(error);
}
bool startUp() {
    return true;
}
void makeNonBlocking(Handle socket) {
    ::fcntl(socket, F_SETFL, ::fcntl(socket, F_GETFL, 0) | O_NONBLOCK);
    ::fcntl(socket, F_SETFD, FD_CLOEXEC);
}
int waitWritable(Handle socket, std::chrono::milliseconds atMost) {
    pollfd item{socket, POLLOUT, 0};
    return ::poll(&item, 1, static_cast<int>(atMost.count()));
}
#endif

using AddressList = std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)>;

AddressList resolve(const QString& host, int port, int& failure) {
    addrinfo hints{};
    hints.ai_family = AF_UNSPEC;
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_protocol = IPPROTO_TCP;
    addrinfo* found = nullptr;
    failure = ::getaddrinfo(host.toUtf8().constData(), QByteArray::number(port).constData(), &hints, &found);
    return {failure == 0 ? found : nullptr, &::freeaddrinfo};
}

Error expired(const Deadline& deadline, const QString& context) {
    return {deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, context,
            QStringLiteral("no response in time")};
}

Error refusal(int error, const QString& context) {
    return {error == kRefused ? ErrorCode::ConnectionRefused : ErrorCode::HostUnreachable, context,
            textOf(error)};
}

Result<Descriptor> connectTo(const addrinfo& address, const Deadline& deadline, const QString& context) {
    const Handle socket = ::socket(address.ai_family, address.ai_socktype, address.ai_protocol);
    if (static_cast<Descriptor>(socket) < 0) {
        return Error{ErrorCode::Internal, context,
                     QStringLiteral("no file descriptors are left for a socket")};
    }
    const auto descriptor = static_cast<Descriptor>(socket);
    makeNonBlocking(socket);
    const auto fail = [&](const Error& error) {
        native_socket::close(descriptor);
        return error;
    };
    if (::connect(socket, address.ai_addr, static_cast<socklen_t>(address.ai_addrlen)) != 0) {
        if (lastError() != kConnectPending) {
            return fail(refusal(lastError(), context));
        }
        while (waitWritable(socket, deadline.nextPoll()) <= 0) {
            if (deadline.hasExpired()) {
                return fail(expired(deadline, context));
            }
        }
        int error = 0;
        socklen_t size = sizeof error;
        ::getsockopt(socket, SOL_SOCKET, SO_ERROR, reinterpret_cast<char*>(&error), &size);
        if (error != 0) {
            return fail(refusal(error, context));
        }
    }
    native_socket::prepare(descriptor);
    native_socket::watchPeer(descriptor);
    return descriptor;
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
                                    : QStringLiteral("port %1; ports are 1 to 65535").arg(port)};
    }
    if (!startUp()) {
        return Error{ErrorCode::Internal, context,
                     QStringLiteral("sockets are not available on this system")};
    }
    int failure = 0;
    const AddressList addresses = resolve(name, port, failure);
    if (!addresses) {
        return Error{ErrorCode::AddressInvalid, context, QStringLiteral("Host not found")};
    }
    Error last;
    for (const addrinfo* address = addresses.get(); address != nullptr; address = address->ai_next) {
        auto connected = connectTo(*address, deadline, context);
        if (connected || deadline.hasExpired()) {
            return connected;
        }
        last = connected.error();
    }
    return last;
}

}  // namespace tiller
