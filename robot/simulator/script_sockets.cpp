// SPDX-License-Identifier: MIT
#include "robot/simulator/script_sockets.h"

namespace tiller::simulator {

namespace {
/// A peer that sends without end is stopped by TCP once this much lies unread [bytes].
constexpr qsizetype kMostUnread = 4 << 20;
}  // namespace

const ScriptSockets::Connection* ScriptSockets::find(std::string_view name) const {
    const auto it = sockets_.find(name);
    return it == sockets_.end() ? nullptr : &it->second;
}

void ScriptSockets::setOwnServices(const QString& address, std::map<int, int> ports) {
    ownAddress_ = address;
    ownPorts_ = std::move(ports);
}

bool ScriptSockets::open(std::string_view name, std::string_view address, int port) {
    close(name);
    if (address.empty() || port <= 0 || port > 65535) {
        return false;
    }
    Connection connection;
    connection.socket = std::make_unique<QTcpSocket>();
    connection.socket->setReadBufferSize(kMostUnread);
    auto host = QString::fromUtf8(address.data(), static_cast<qsizetype>(address.size()));
    const auto own = ownPorts_.find(port);
    if (own != ownPorts_.end() && (address == "127.0.0.1" || address == "localhost")) {
        host = ownAddress_;
        port = own->second;
    }
    QTcpSocket* socket = connection.socket.get();
    QObject::connect(socket, &QTcpSocket::connected, socket,
                     [socket] { socket->setSocketOption(QAbstractSocket::LowDelayOption, 1); });
    socket->connectToHost(host, static_cast<quint16>(port));
    sockets_.insert_or_assign(std::string(name), std::move(connection));
    return true;
}

ScriptSockets::State ScriptSockets::state(std::string_view name) const {
    const Connection* connection = find(name);
    if (connection == nullptr) {
        return State::Closed;
    }
    switch (connection->socket->state()) {
        case QAbstractSocket::ConnectedState:
            return State::Open;
        case QAbstractSocket::HostLookupState:
        case QAbstractSocket::ConnectingState:
            return State::Connecting;
        default:
            return State::Closed;
    }
}

void ScriptSockets::close(std::string_view name) {
    const auto it = sockets_.find(name);
    if (it != sockets_.end()) {
        it->second.socket->flush();
        sockets_.erase(it);
    }
}

bool ScriptSockets::send(std::string_view name, std::string_view bytes) {
    const Connection* connection = find(name);
    if (connection == nullptr || connection->socket->state() != QAbstractSocket::ConnectedState) {
        return false;
    }
    const auto size = static_cast<qint64>(bytes.size());
    if (connection->socket->write(bytes.data(), size) != size) {
        return false;
    }
    connection->socket->flush();
    return true;
}

std::string_view ScriptSockets::received(std::string_view name) const {
    const Connection* connection = find(name);
    return connection == nullptr ? std::string_view()
                                 : std::string_view(connection->received.constData(),
                                                    static_cast<std::size_t>(connection->received.size()));
}

void ScriptSockets::consume(std::string_view name, std::size_t count) {
    const auto it = sockets_.find(name);
    if (it != sockets_.end()) {
        it->second.received.remove(0, static_cast<qsizetype>(count));
    }
}

void ScriptSockets::service() {
    for (auto& [name, connection] : sockets_) {
        if (connection.received.size() < kMostUnread && connection.socket->bytesAvailable() > 0) {
            connection.received += connection.socket->readAll();
        }
    }
}

}  // namespace tiller::simulator
