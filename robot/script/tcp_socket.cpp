// SPDX-License-Identifier: MIT
#include "robot/script/tcp_socket.h"

#include <QTcpSocket>

#include "robot/core/qt_main_thread.h"
#include "robot/core/tcp_connect.h"

namespace tiller::script {

Result<std::unique_ptr<QTcpSocket>> openTcpSocket(const QString& host, int port, const Deadline& deadline) {
    adoptMainThread();
    const auto descriptor = tiller::connectTcp(host, port, deadline);
    if (!descriptor) {
        return descriptor.error();
    }
    auto socket = std::make_unique<QTcpSocket>();
    if (!socket->setSocketDescriptor(*descriptor)) {
        native_socket::close(*descriptor);
        return Error{ErrorCode::Internal, QStringLiteral("connect to %1:%2").arg(host).arg(port),
                     socket->errorString()};
    }
    return socket;
}

}  // namespace tiller::script
