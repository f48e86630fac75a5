// SPDX-License-Identifier: MIT
#include "robot/script/tcp_connect.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QNetworkProxy>
#include <QTcpSocket>
#include <QTimer>

namespace tiller::script {

namespace {

ErrorCode codeOf(QAbstractSocket::SocketError error) {
    switch (error) {
        case QAbstractSocket::ConnectionRefusedError:
            return ErrorCode::ConnectionRefused;
        case QAbstractSocket::HostNotFoundError:
            return ErrorCode::AddressInvalid;
        case QAbstractSocket::RemoteHostClosedError:
            return ErrorCode::ConnectionClosed;
        case QAbstractSocket::SocketTimeoutError:
            return ErrorCode::Timeout;
        default:
            return ErrorCode::HostUnreachable;
    }
}

// Without an application object there is no event loop to wait in; then a cancel waits for the deadline.
void waitForOutcome(QTcpSocket& socket, const Deadline& deadline) {
    if (QCoreApplication::instance() == nullptr) {
        socket.waitForConnected(static_cast<int>(deadline.remaining().count()));
        return;
    }
    QEventLoop loop;
    QTimer poll;
    QObject::connect(&socket, &QTcpSocket::connected, &loop, &QEventLoop::quit);
    QObject::connect(&socket, &QTcpSocket::errorOccurred, &loop, &QEventLoop::quit);
    QObject::connect(&poll, &QTimer::timeout, &loop, [&] {
        if (deadline.hasExpired()) {
            loop.quit();
        }
    });
    poll.start(std::chrono::milliseconds(10));
    const bool undecided = socket.state() != QAbstractSocket::ConnectedState &&
                           socket.error() == QAbstractSocket::UnknownSocketError;
    if (undecided && !deadline.hasExpired()) {
        loop.exec(QEventLoop::ExcludeUserInputEvents);
    }
}

}  // namespace

Result<std::unique_ptr<QTcpSocket>> connectTcp(const QString& host, int port, const Deadline& deadline) {
    const QString context = QStringLiteral("connect to %1:%2").arg(host).arg(port);
    constexpr int kMaxPort = 65535;
    if (host.trimmed().isEmpty() || port <= 0 || port > kMaxPort) {
        return Error{ErrorCode::AddressInvalid, context, {}};
    }
    auto socket = std::make_unique<QTcpSocket>();
    socket->setProxy(QNetworkProxy::NoProxy);
    socket->connectToHost(host.trimmed(), static_cast<quint16>(port));
    waitForOutcome(*socket, deadline);
    if (socket->state() != QAbstractSocket::ConnectedState) {
        if (deadline.isCancelled()) {
            return Error{ErrorCode::Cancelled, context, {}};
        }
        if (socket->error() == QAbstractSocket::UnknownSocketError) {
            return Error{ErrorCode::Timeout, context, {}};
        }
        return Error{codeOf(socket->error()), context, socket->errorString()};
    }
    socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
    return socket;
}

}  // namespace tiller::script
