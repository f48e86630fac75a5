// SPDX-License-Identifier: MIT
#include "robot/live/detail/foxglove_server.h"

#include <QDateTime>
#include <QHostAddress>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QWebSocket>
#include <QtEndian>
#include <algorithm>
#include <cmath>
#include <optional>

namespace tiller::live {

namespace {

constexpr int kMostViewers = 16;
constexpr quint64 kLongestRequest = 256 * 1024;
constexpr int kMostSubscriptions = 1000;
// What a viewer may be behind before messages are left out for it: seconds of all there is.
constexpr qint64 kMostUnsent = 8 << 20;
constexpr char kMessageData = 0x01;

QByteArray toText(const QJsonObject& object) {
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

QJsonObject describe(const LiveChannel& channel) {
    return {{"id", static_cast<qint64>(channel.id)},
            {"topic", QString::fromStdString(channel.topic)},
            {"encoding", "cdr"},
            {"schemaName", QString::fromStdString(channel.type)},
            {"schema", QString::fromStdString(channel.definition)},
            {"schemaEncoding", "ros2msg"}};
}

void tell(QWebSocket* socket, int level, const QString& message) {
    socket->sendTextMessage(
        QString::fromUtf8(toText({{"op", "status"}, {"level", level}, {"message", message}})));
}

/// A number that a message may have, or nothing.
std::optional<std::uint32_t> numberOf(const QJsonValue& value) {
    const double number = value.toDouble(-1);
    if (number < 0 || number > 4294967295.0 || number != std::floor(number)) {
        return std::nullopt;
    }
    return static_cast<std::uint32_t>(number);
}

}  // namespace

FoxgloveServer::FoxgloveServer(const QString& name)
    : name_(name)
    , session_(QString::number(QDateTime::currentMSecsSinceEpoch()))
    , server_(name, QWebSocketServer::NonSecureMode) {
    server_.setSupportedSubprotocols(
        {QStringLiteral("foxglove.sdk.v1"), QStringLiteral("foxglove.websocket.v1")});
    server_.setMaxPendingConnections(kMostViewers);
    connect(&server_, &QWebSocketServer::newConnection, this, &FoxgloveServer::welcome);
}

FoxgloveServer::~FoxgloveServer() {
    server_.close();
    const QList<QWebSocket*> sockets = clients_.keys();
    for (QWebSocket* socket : sockets) {
        socket->disconnect(this);
        socket->close(QWebSocketProtocol::CloseCodeGoingAway);
        socket->flush();
        delete socket;
    }
}

Result<void> FoxgloveServer::listen(const QString& address, std::uint16_t port) {
    QHostAddress host;
    if (!host.setAddress(address)) {
        return Error{ErrorCode::AddressInvalid, QStringLiteral("listen on %1").arg(address),
                     QStringLiteral("that is not an address, such as 127.0.0.1")};
    }
    if (!server_.listen(host, port)) {
        return Error{ErrorCode::Rejected, QStringLiteral("listen on %1 port %2").arg(address).arg(port),
                     server_.errorString()};
    }
    return {};
}

void FoxgloveServer::advertise(const LiveChannel& channel) {
    QJsonArray gone;
    std::erase_if(channels_, [&](const LiveChannel& known) {
        if (known.topic == channel.topic) {
            gone.append(static_cast<qint64>(known.id));
            return true;
        }
        return false;
    });
    channels_.push_back(channel);
    const QString removed = QString::fromUtf8(toText({{"op", "unadvertise"}, {"channelIds", gone}}));
    const QString added =
        QString::fromUtf8(toText({{"op", "advertise"}, {"channels", QJsonArray{describe(channel)}}}));
    for (auto client = clients_.begin(); client != clients_.end(); ++client) {
        if (!gone.isEmpty()) {
            client.key()->sendTextMessage(removed);
        }
        client.key()->sendTextMessage(added);
    }
}

void FoxgloveServer::welcome() {
    while (QWebSocket* socket = server_.nextPendingConnection()) {
        socket->setParent(this);
        if (clients_.size() >= kMostViewers) {
            socket->close(QWebSocketProtocol::CloseCodePolicyViolated, QStringLiteral("too many viewers"));
            socket->deleteLater();
            continue;
        }
        socket->setMaxAllowedIncomingMessageSize(kLongestRequest);
        clients_.insert(socket, {});
        connect(socket, &QWebSocket::textMessageReceived, this,
                [this, socket](const QString& text) { hear(socket, text); });
        connect(socket, &QWebSocket::disconnected, this, [this, socket] { forget(socket); });
        socket->sendTextMessage(QString::fromUtf8(toText({{"op", "serverInfo"},
                                                          {"name", name_},
                                                          {"capabilities", QJsonArray()},
                                                          {"supportedEncodings", QJsonArray{"cdr"}},
                                                          {"metadata", QJsonObject{{"ROS_DISTRO", "humble"}}},
                                                          {"sessionId", session_}})));
        QJsonArray channels;
        for (const LiveChannel& channel : channels_) {
            channels.append(describe(channel));
        }
        socket->sendTextMessage(QString::fromUtf8(toText({{"op", "advertise"}, {"channels", channels}})));
    }
}

void FoxgloveServer::hear(QWebSocket* socket, const QString& text) {
    const QJsonObject request = QJsonDocument::fromJson(text.toUtf8()).object();
    const QString op = request["op"].toString();
    Client& client = clients_[socket];
    constexpr int kError = 2;
    if (op == QLatin1String("subscribe")) {
        for (const QJsonValue& each : request["subscriptions"].toArray()) {
            const auto id = numberOf(each["id"]);
            const auto channel = numberOf(each["channelId"]);
            if (id && channel) {
                subscribe(socket, client, *id, *channel);
            } else {
                tell(socket, kError, QStringLiteral("a subscription needs an id and a channelId"));
            }
        }
    } else if (op == QLatin1String("unsubscribe")) {
        for (const QJsonValue& each : request["subscriptionIds"].toArray()) {
            if (const auto id = numberOf(each)) {
                unsubscribe(client, *id);
            }
        }
    } else {
        tell(
            socket, kError,
            QStringLiteral("\"%1\" is not served here: data can be subscribed to, no more").arg(op.left(40)));
    }
}

void FoxgloveServer::subscribe(QWebSocket* socket, Client& client, std::uint32_t id, std::uint32_t channel) {
    constexpr int kError = 2;
    const bool exists = std::any_of(channels_.begin(), channels_.end(),
                                    [&](const LiveChannel& known) { return known.id == channel; });
    if (!exists) {
        tell(socket, kError, QStringLiteral("there is no channel %1").arg(channel));
    } else if (client.subscriptions.contains(id) || client.subscriptions.size() >= kMostSubscriptions) {
        tell(socket, kError, QStringLiteral("subscription %1 is taken").arg(id));
    } else {
        client.subscriptions.insert(id, channel);
        ++wanted_[channel];
    }
}

void FoxgloveServer::unsubscribe(Client& client, std::uint32_t id) {
    const auto found = client.subscriptions.find(id);
    if (found != client.subscriptions.end()) {
        --wanted_[found.value()];
        client.subscriptions.erase(found);
    }
}

void FoxgloveServer::forget(QWebSocket* socket) {
    const auto client = clients_.find(socket);
    if (client != clients_.end()) {
        for (const std::uint32_t channel : std::as_const(client->subscriptions)) {
            --wanted_[channel];
        }
        clients_.erase(client);
    }
    socket->deleteLater();
}

void FoxgloveServer::send(std::uint32_t channel, std::uint64_t timeNs, const std::string& message) {
    constexpr qsizetype kHead = 1 + 4 + 8;
    QByteArray bytes(kHead, Qt::Uninitialized);
    bytes.append(message.data(), static_cast<qsizetype>(message.size()));
    bytes[0] = kMessageData;
    qToLittleEndian(timeNs, bytes.data() + 1 + 4);
    for (auto client = clients_.begin(); client != clients_.end(); ++client) {
        for (auto each = client->subscriptions.begin(); each != client->subscriptions.end(); ++each) {
            if (each.value() != channel) {
                continue;
            }
            if (client.key()->bytesToWrite() > kMostUnsent) {
                ++dropped_;
                if (!std::exchange(client->isSlow, true)) {
                    constexpr int kWarning = 1;
                    tell(client.key(), kWarning,
                         QStringLiteral("this viewer is too slow: messages are left out"));
                }
                continue;
            }
            qToLittleEndian(each.key(), bytes.data() + 1);
            client.key()->sendBinaryMessage(bytes);
            ++sent_;
        }
    }
}

}  // namespace tiller::live
