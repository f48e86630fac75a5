// SPDX-License-Identifier: MIT
#include "robot/script/script_client.h"

#include <array>
#include <utility>

#include "robot/core/tcp_connect.h"

namespace tiller::script {

using native_socket::Status;

namespace {

/// Discards data streamed by the controller.
Status readUnwanted(native_socket::Descriptor socket) {
    std::array<std::uint8_t, 16384> unwanted;
    constexpr int kReads = 256;  // more than a socket buffer; limits the time spent on a flood of data
    Status status = Status::Ok;
    for (int i = 0; i < kReads && status == Status::Ok; ++i) {
        status = native_socket::receive(socket, unwanted).status;
    }
    return status;
}

}  // namespace

ScriptClient::ScriptClient(Text host, int port) : host_(std::move(host)), port_(port) {}

ScriptClient::~ScriptClient() {
    close();
}

Result<void> ScriptClient::connect(const Deadline& deadline) {
    close();
    const auto socket = connectTcp(host_, port_, deadline);
    if (!socket) {
        return socket.error();
    }
    socket_ = *socket;
    return {};
}

Result<void> ScriptClient::send(const Text& text, const Deadline& deadline) {
    const QString context = QStringLiteral("send a script to %1:%2").arg(host_).arg(port_);
    if (text.trimmed().isEmpty()) {
        return Error{ErrorCode::InvalidArgument, context, QStringLiteral("the script is empty")};
    }
    const bool hadConnection = socket_ >= 0;
    if (!isConnected()) {
        return Error{hadConnection ? ErrorCode::ConnectionClosed : ErrorCode::NotConnected, context, {}};
    }
    QByteArray bytes = text.toUtf8();
    if (!bytes.endsWith('\n')) {
        bytes.append('\n');
    }
    const auto* begin = reinterpret_cast<const std::uint8_t*>(bytes.constData());
    std::span<const std::uint8_t> left(begin, static_cast<std::size_t>(bytes.size()));
    while (!left.empty()) {
        const native_socket::Transfer sent = native_socket::send(socket_, left);
        if (sent.status == Status::Ok) {
            left = left.subspan(sent.bytes);
            continue;
        }
        if (sent.status != Status::WouldBlock || !isConnected()) {
            close();
            return Error{ErrorCode::ConnectionClosed, context, {}};
        }
        if (deadline.hasExpired()) {
            // Only a part of the program was sent. Close the connection, so that no further text is appended
            // to this part.
            close();
            return Error{deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, context, {}};
        }
        native_socket::waitWritable(socket_, deadline.nextPoll());
    }
    return {};
}

void ScriptClient::close() {
    if (socket_ >= 0) {
        // Closing a socket with unread data resets the connection and can discard the sent program.
        readUnwanted(socket_);
        native_socket::close(std::exchange(socket_, -1));
    }
}

bool ScriptClient::isConnected() {
    const Status status = socket_ >= 0 ? readUnwanted(socket_) : Status::Closed;
    if (status == Status::Closed || status == Status::Failed) {
        close();
    }
    return socket_ >= 0;
}

}  // namespace tiller::script
