// SPDX-License-Identifier: MIT
#include "robot/simulator/host/script_sockets.h"

#include <QHostAddress>

namespace tiller::simulator {

namespace {
/// Size of each of three buffers [bytes]: operating system, socket, and this class.
constexpr qsizetype kShare = 16 << 10;
/// Buffer limit of this class while the program waits for the end of a long message [bytes].
constexpr qsizetype kMaxUnread = 4 << 20;
}  // namespace

void ScriptSockets::Connection::takeIn() {
    const qsizetype room = (wantsMore ? kMaxUnread : kShare) - received.size();
    if (room > 0 && socket->bytesAvailable() > 0) {
        received += socket->read(room);
    }
}

const ScriptSockets::Connection* ScriptSockets::find(std::string_view name) const {
    const auto it = sockets_.find(name);
    return it == sockets_.end() ? nullptr : &it->second;
}

void ScriptSockets::setOwnServices(const QString& address, std::map<int, int> ports) {
    ownAddress_ = address;
    ownPorts_ = std::move(ports);
}

bool ScriptSockets::openSocket(std::string_view name, std::string_view address, int port) {
    closeSocket(name);
    if (address.empty() || port <= 0 || port > 65535) {
        return false;
    }
    Connection connection;
    connection.socket = std::make_unique<QTcpSocket>();
    connection.socket->setReadBufferSize(kShare);
    auto host = QString::fromUtf8(address.data(), static_cast<qsizetype>(address.size()));
    const auto own = ownPorts_.find(port);
    if (const auto device = devices_.find({host.toLower(), port}); device != devices_.end()) {
        host = ownAddress_;
        port = device->second;
    } else if (own != ownPorts_.end() && (address == "127.0.0.1" || address == "localhost")) {
        host = ownAddress_;
        port = own->second;
    }
    QTcpSocket* socket = connection.socket.get();
    QObject::connect(socket, &QTcpSocket::connected, socket,
                     [socket] { socket->setSocketOption(QAbstractSocket::LowDelayOption, 1); });
    // The buffer size must be set before the connection is established, which requires the address family. A
    // host name can resolve to either family, so its socket keeps the default size.
    const QHostAddress literal(host);
    const bool is6 = literal.protocol() == QAbstractSocket::IPv6Protocol;
    if (!literal.isNull() && socket->bind(is6 ? QHostAddress::AnyIPv6 : QHostAddress::AnyIPv4)) {
        socket->setSocketOption(QAbstractSocket::ReceiveBufferSizeSocketOption, static_cast<int>(kShare));
    }
    socket->connectToHost(host, static_cast<quint16>(port));
    sockets_.insert_or_assign(std::string(name), std::move(connection));
    return true;
}

ScriptSockets::State ScriptSockets::socketState(std::string_view name) const {
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
            // Data received before the end of the connection can still be read.
            return connection->socket->bytesAvailable() > 0 ? State::Open : State::Closed;
    }
}

void ScriptSockets::closeSocket(std::string_view name) {
    const auto it = sockets_.find(name);
    if (it != sockets_.end()) {
        it->second.socket->flush();
        sockets_.erase(it);
    }
}

bool ScriptSockets::sendSocket(std::string_view name, std::string_view bytes) {
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

std::string_view ScriptSockets::receivedBytes(std::string_view name) const {
    const Connection* connection = find(name);
    if (connection == nullptr) {
        return {};
    }
    connection->wantsMore = true;
    return {connection->received.constData(), static_cast<std::size_t>(connection->received.size())};
}

void ScriptSockets::consumeBytes(std::string_view name, std::size_t count) {
    const auto it = sockets_.find(name);
    if (it != sockets_.end()) {
        it->second.received.remove(0, static_cast<qsizetype>(count));
        it->second.wantsMore = false;
        if (it->second.received.size() < kShare / 2) {
            it->second.takeIn();
        }
    }
}

void ScriptSockets::serviceSockets() {
    for (auto& [name, connection] : sockets_) {
        connection.takeIn();
    }
}

}  // namespace tiller::simulator
