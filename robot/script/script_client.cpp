// SPDX-License-Identifier: MIT
#include "robot/script/script_client.h"

#include <QTcpSocket>
#include <utility>

#include "robot/script/tcp_connect.h"

namespace tiller::script {

ScriptClient::ScriptClient(QString host, int port) : host_(std::move(host)), port_(port) {}

ScriptClient::~ScriptClient() = default;

Result<void> ScriptClient::connect(const Deadline& deadline) {
    close();
    auto socket = connectTcp(host_, port_, deadline);
    if (!socket) {
        return socket.error();
    }
    socket_ = std::move(socket).value();
    return {};
}

Result<void> ScriptClient::send(const QString& text, const Deadline& deadline) {
    const QString context = QStringLiteral("send a script to %1:%2").arg(host_).arg(port_);
    if (text.trimmed().isEmpty()) {
        return Error{ErrorCode::InvalidArgument, context, QStringLiteral("the script is empty")};
    }
    if (!isConnected()) {
        return Error{ErrorCode::NotConnected, context, {}};
    }
    QByteArray bytes = text.toUtf8();
    if (!bytes.endsWith('\n')) {
        bytes.append('\n');
    }
    socket_->write(bytes);
    while (socket_->bytesToWrite() > 0) {
        if (deadline.hasExpired()) {
            // Half a program is on its way: only a closed connection keeps the rest from being glued to it.
            close();
            return Error{deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, context, {}};
        }
        const auto slice = std::max(deadline.nextPoll(), std::chrono::milliseconds(1));
        if (!socket_->waitForBytesWritten(static_cast<int>(slice.count())) &&
            socket_->state() != QAbstractSocket::ConnectedState) {
            const Error error{ErrorCode::ConnectionClosed, context, socket_->errorString()};
            close();
            return error;
        }
        // The controller streams its state on this port too. Nobody needs it here, but a receive buffer left
        // to fill up would make some controllers hang up.
        socket_->skip(socket_->bytesAvailable());
    }
    return {};
}

void ScriptClient::close() {
    if (socket_) {
        socket_->abort();
        socket_.reset();
    }
}

bool ScriptClient::isConnected() const {
    return socket_ && socket_->state() == QAbstractSocket::ConnectedState;
}

}  // namespace tiller::script
