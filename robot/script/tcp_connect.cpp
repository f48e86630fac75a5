// SPDX-License-Identifier: MIT
#include "robot/script/tcp_connect.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QNetworkProxy>
#include <QTcpSocket>
#include <QTimer>
#include <optional>

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

// Runs the thread's events until the outcome is known.
void waitForOutcome(QTcpSocket& socket, QEventLoop& loop, const Deadline& deadline) {
    QTimer poll;
    QObject::connect(&socket, &QTcpSocket::connected, &loop, &QEventLoop::quit);
    QObject::connect(&socket, &QTcpSocket::errorOccurred, &loop, &QEventLoop::quit);
    QObject::connect(&poll, &QTimer::timeout, &loop, [&] {
        if (deadline.hasExpired()) {
            loop.quit();
        }
    });
    poll.start(std::chrono::milliseconds(10));
    while (socket.state() != QAbstractSocket::ConnectedState &&
           socket.state() != QAbstractSocket::UnconnectedState && !deadline.hasExpired()) {
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
    // The loop comes before the socket: it gives a thread that is not one of Qt's the dispatcher without
    // which the socket would never hear of its connection. Without an application object there is none; then
    // a cancel waits for the deadline.
    std::optional<QEventLoop> loop;
    if (QCoreApplication::instance() != nullptr) {
        loop.emplace();
    }
    auto socket = std::make_unique<QTcpSocket>();
    socket->setProxy(QNetworkProxy::NoProxy);
    socket->connectToHost(host.trimmed(), static_cast<quint16>(port));
    if (loop) {
        waitForOutcome(*socket, *loop, deadline);
    } else {
        socket->waitForConnected(static_cast<int>(deadline.remaining().count()));
    }
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
