// SPDX-License-Identifier: MIT
#include "robot/live/detail/foxglove_server.h"

#include <QDateTime>
#include <QHostAddress>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTcpSocket>
#include <QWebSocket>
#include <QWebSocketCorsAuthenticator>
#include <QtEndian>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace tiller::live {

namespace {

constexpr int kAcceptedAtOnce = 8;
constexpr int kMaxShownOrigin = 200;  // [characters]
// Kernel send buffer per connection. Its content can no longer be dropped, so it is limited to less than a
// second of messages.
constexpr int kSendBuffer = 256 * 1024;
constexpr qint64 kMaxUnsent = 64 * 1024;
constexpr qint64 kMaxUnreadAnswers = 256 * 1024;
constexpr std::chrono::milliseconds kMinStallCheck{10};
constexpr std::chrono::milliseconds kMaxStallCheck{1000};
constexpr char kMessageData = 0x01;
constexpr int kWarning = 1;
constexpr int kError = 2;

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

/// Converts a number in a message; empty if it is invalid.
std::optional<std::uint32_t> numberOf(const QJsonValue& value) {
    const double number = value.toDouble(-1);
    if (number < 0 || number > 4294967295.0 || number != std::floor(number)) {
        return std::nullopt;
    }
    return static_cast<std::uint32_t>(number);
}

}  // namespace

FoxgloveServer::FoxgloveServer(const QString& name, AllowedOrigins origins, const LiveLimits& limits)
    : name_(name)
    , session_(QString::number(QDateTime::currentMSecsSinceEpoch()))
    , origins_(std::move(origins))
    , limits_(limits)
    , upgrader_(name, QWebSocketServer::NonSecureMode) {
    upgrader_.setSupportedSubprotocols(
        {QStringLiteral("foxglove.sdk.v1"), QStringLiteral("foxglove.websocket.v1")});
    // Use a queued connection, so that the event loop serves connected viewers between two batches.
    listener_.setMaxPendingConnections(kAcceptedAtOnce);
    connect(&listener_, &QTcpServer::newConnection, this, &FoxgloveServer::accept, Qt::QueuedConnection);
    connect(&upgrader_, &QWebSocketServer::originAuthenticationRequired, this,
            [this](QWebSocketCorsAuthenticator* authenticator) {
                authenticator->setAllowed(origins_.allow(authenticator->origin()));
                if (!authenticator->allowed()) {
                    ++refused_;
                    refusedOrigin_ = authenticator->origin().left(kMaxShownOrigin);
                }
            });
    connect(&upgrader_, &QWebSocketServer::newConnection, this, &FoxgloveServer::welcome);
    connect(&stallTimer_, &QTimer::timeout, this, &FoxgloveServer::closeStalledClients);
    stallTimer_.start(std::clamp(limits_.stallTimeout / 10, kMinStallCheck, kMaxStallCheck));
}

FoxgloveServer::~FoxgloveServer() {
    listener_.close();
    const QList<QWebSocket*> sockets = clients_.keys();
    for (QWebSocket* socket : sockets) {
        socket->disconnect(this);
        socket->close(QWebSocketProtocol::CloseCodeGoingAway);
        socket->flush();
        delete socket;
    }
    for (const Handshake& handshake : handshakes_) {
        handshake.socket->disconnect(this);
        handshake.socket->abort();
    }
}

Result<void> FoxgloveServer::listen(const QString& address, std::uint16_t port) {
    QHostAddress host;
    if (!host.setAddress(address)) {
        return Error{ErrorCode::AddressInvalid, QStringLiteral("listen on %1").arg(address),
                     QStringLiteral("this is not an IP address; use an address such as 127.0.0.1")};
    }
    if (!listener_.listen(host, port)) {
        return Error{ErrorCode::Rejected, QStringLiteral("listen on %1 port %2").arg(address).arg(port),
                     listener_.errorString()};
    }
    return {};
}

void FoxgloveServer::advertise(const LiveChannel& channel) {
    QJsonArray removedIds;
    std::erase_if(channels_, [&](const LiveChannel& known) {
        if (known.topic == channel.topic) {
            removedIds.append(static_cast<qint64>(known.id));
            return true;
        }
        return false;
    });
    channels_.push_back(channel);
    const QString removed = QString::fromUtf8(toText({{"op", "unadvertise"}, {"channelIds", removedIds}}));
    const QString added =
        QString::fromUtf8(toText({{"op", "advertise"}, {"channels", QJsonArray{describe(channel)}}}));
    for (auto client = clients_.begin(); client != clients_.end(); ++client) {
        if (!removedIds.isEmpty()) {
            client.key()->sendTextMessage(removed);
        }
        client.key()->sendTextMessage(added);
    }
}

void FoxgloveServer::accept() {
    while (QTcpSocket* socket = listener_.nextPendingConnection()) {
        while (handshakes_.size() >= static_cast<std::size_t>(limits_.maxIdleConnections)) {
            ++disconnected_;
            QTcpSocket* const oldest = handshakes_.front().socket;
            handshakes_.pop_front();
            oldest->abort();
        }
        const auto isOfSocket = [socket](const Handshake& each) { return each.socket == socket; };
        handshakes_.push_back({socket, std::make_shared<Incoming>()});
        connect(socket, &QTcpSocket::disconnected, this,
                [this, isOfSocket] { std::erase_if(handshakes_, isOfSocket); });
        QTimer::singleShot(limits_.handshakeTimeout, socket, [this, socket, isOfSocket] {
            if (std::any_of(handshakes_.begin(), handshakes_.end(), isOfSocket)) {
                ++disconnected_;
                socket->abort();
            }
        });
        connect(socket, &QTcpSocket::readyRead, this,
                [this, socket, incoming = handshakes_.back().incoming] { countIncoming(socket, *incoming); });
        // QWebSocketServer stores up to 800 kB of an unfinished header. This socket never holds more than its
        // buffer.
        socket->setReadBufferSize(limits_.maxHeaderBytes);
        socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
        socket->setSocketOption(QAbstractSocket::SendBufferSizeSocketOption, kSendBuffer);
        upgrader_.handleConnection(socket);
    }
}

// QWebSocketServer emits newConnection while it processes the handshake of this socket.
void FoxgloveServer::welcome() {
    while (QWebSocket* socket = upgrader_.nextPendingConnection()) {
        const auto found =
            std::find_if(handshakes_.begin(), handshakes_.end(), [socket](const Handshake& each) {
                return each.socket->peerPort() == socket->peerPort() &&
                       each.socket->peerAddress() == socket->peerAddress();
            });
        if (found == handshakes_.end()) {
            socket->abort();
            socket->deleteLater();
            continue;
        }
        const auto [tcp, incoming] = *found;
        handshakes_.erase(found);
        socket->setParent(this);
        tcp->setParent(socket);
        // One frame including its header must fit in the buffer.
        constexpr qint64 kMaxFrameHeader = 14;
        socket->setReadBufferSize(
            std::max(limits_.maxHeaderBytes, limits_.maxRequestBytes + kMaxFrameHeader));
        socket->setMaxAllowedIncomingFrameSize(static_cast<quint64>(limits_.maxRequestBytes));
        socket->setMaxAllowedIncomingMessageSize(static_cast<quint64>(limits_.maxRequestBytes));
        Client client;
        client.order = ++accepted_;
        client.waitingSince = std::chrono::steady_clock::now();
        clients_.insert(socket, client);
        connect(socket, &QWebSocket::textMessageReceived, this,
                [this, socket](const QString& text) { receive(socket, text); });
        connect(socket, &QWebSocket::bytesWritten, this, [this, socket] {
            if (const auto it = clients_.find(socket); it != clients_.end()) {
                it->waitingSince = std::chrono::steady_clock::now();
                sendQueued(socket, *it);
            }
        });
        connect(socket, &QWebSocket::disconnected, this, [this, socket] { forget(socket); });
        // Connect this handler after Qt's handler, so that it runs after Qt has consumed the data.
        connect(tcp, &QTcpSocket::readyRead, this, [this, socket, tcp = tcp, incoming = incoming] {
            incoming->unread = tcp->bytesAvailable();
            closeIfUnread(socket);
        });
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
        closeOldestIdleClient();
    }
}

// Called before Qt reads the data.
void FoxgloveServer::countIncoming(QTcpSocket* socket, Incoming& incoming) {
    const qint64 available = socket->bytesAvailable();
    const Time now = std::chrono::steady_clock::now();
    if (now - incoming.windowBegin >= std::chrono::seconds(1)) {
        incoming.windowBegin = now;
        incoming.inWindow = 0;
    }
    incoming.inWindow += std::max<qint64>(0, available - incoming.unread);
    incoming.unread = available;
    if (incoming.inWindow > limits_.maxRequestRate) {
        if (auto* const viewer = qobject_cast<QWebSocket*>(socket->parent())) {
            disconnectLater(viewer, QStringLiteral("too many requests"));
        }
    }
}

// Replies and pongs are written to the socket directly, so LiveLimits::maxQueueBytes does not limit them.
void FoxgloveServer::closeIfUnread(QWebSocket* socket) {
    if (socket->bytesToWrite() > kMaxUnreadAnswers) {
        disconnectLater(socket, QStringLiteral("the viewer is not reading the responses"));
    }
}

void FoxgloveServer::receive(QWebSocket* socket, const QString& text) {
    const auto found = clients_.find(socket);
    if (found == clients_.end() || found->isClosing) {
        return;
    }
    Client& client = *found;
    const QJsonObject request = QJsonDocument::fromJson(text.toUtf8()).object();
    const QString op = request["op"].toString();
    if (op == QLatin1String("subscribe")) {
        for (const QJsonValue& each : request["subscriptions"].toArray()) {
            const auto id = numberOf(each["id"]);
            const auto channel = numberOf(each["channelId"]);
            if (id && channel) {
                subscribe(socket, client, *id, *channel);
            } else {
                report(socket, kError, QStringLiteral("a subscription requires an id and a channelId"));
            }
            if (client.isClosing) {
                return;
            }
        }
    } else if (op == QLatin1String("unsubscribe")) {
        for (const QJsonValue& each : request["subscriptionIds"].toArray()) {
            if (const auto id = numberOf(each)) {
                unsubscribe(client, *id);
            }
        }
    } else {
        report(socket, kError,
               QStringLiteral("\"%1\" is not supported: this server only offers subscriptions")
                   .arg(op.left(40)));
    }
}

void FoxgloveServer::subscribe(QWebSocket* socket, Client& client, std::uint32_t id, std::uint32_t channel) {
    const bool exists = std::any_of(channels_.begin(), channels_.end(),
                                    [&](const LiveChannel& known) { return known.id == channel; });
    const QList<std::uint32_t> channels = client.subscriptions.values();
    if (!exists) {
        report(socket, kError, QStringLiteral("channel %1 does not exist").arg(channel));
    } else if (client.subscriptions.contains(id)) {
        report(socket, kError, QStringLiteral("subscription %1 is in use").arg(id));
    } else if (channels.contains(channel)) {
        // Each subscription to a channel costs one copy of each message.
        report(socket, kError, QStringLiteral("channel %1 is already subscribed to").arg(channel));
    } else if (channels.isEmpty() && subscribedViewers() >= limits_.maxViewers) {
        report(socket, kError,
               QStringLiteral("too many viewers: at most %1 can subscribe").arg(limits_.maxViewers));
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

int FoxgloveServer::subscribedViewers() const {
    return static_cast<int>(std::count_if(clients_.begin(), clients_.end(), [](const Client& client) {
        return !client.subscriptions.isEmpty();
    }));
}

void FoxgloveServer::report(QWebSocket* socket, int level, const QString& message) {
    socket->sendTextMessage(
        QString::fromUtf8(toText({{"op", "status"}, {"level", level}, {"message", message}})));
    closeIfUnread(socket);
}

void FoxgloveServer::closeOldestIdleClient() {
    QWebSocket* oldest = nullptr;
    int idle = 0;
    std::uint64_t order = 0;
    for (auto client = clients_.begin(); client != clients_.end(); ++client) {
        if (client->subscriptions.isEmpty() && !client->isClosing) {
            ++idle;
            if (oldest == nullptr || client->order < order) {
                oldest = client.key();
                order = client->order;
            }
        }
    }
    if (idle > limits_.maxIdleConnections) {
        disconnectLater(oldest, QStringLiteral("too many connections without a subscription"));
    }
}

void FoxgloveServer::closeStalledClients() {
    const Time now = std::chrono::steady_clock::now();
    for (auto client = clients_.begin(); client != clients_.end(); ++client) {
        if (client.key()->bytesToWrite() == 0 && client->queue.empty()) {
            client->waitingSince = now;
        } else if (now - client->waitingSince > limits_.stallTimeout) {
            disconnectLater(client.key(), QStringLiteral("the viewer is not reading the messages"));
        }
    }
}

// Closes the connection later, because the caller may be iterating over the clients, or Qt may be reading from
// the socket.
void FoxgloveServer::disconnectLater(QWebSocket* socket, const QString& reason) {
    const auto client = clients_.find(socket);
    if (client == clients_.end() || std::exchange(client->isClosing, true)) {
        return;
    }
    ++disconnected_;
    client->queue.clear();
    client->queuedBytes = 0;
    QMetaObject::invokeMethod(
        socket,
        [socket, reason] {
            socket->close(QWebSocketProtocol::CloseCodePolicyViolated, reason);
            // With a graceful close, a peer that is not reading would keep the connection open.
            socket->abort();
        },
        Qt::QueuedConnection);
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
        if (client->isClosing) {
            continue;
        }
        for (auto each = client->subscriptions.begin(); each != client->subscriptions.end(); ++each) {
            if (each.value() == channel) {
                enqueue(client.key(), *client, {each.key(), bytes});
            }
        }
    }
}

void FoxgloveServer::enqueue(QWebSocket* socket, Client& client, Queued next) {
    client.queuedBytes += next.message.size();
    client.queue.push_back(std::move(next));
    sendQueued(socket, client);
    while (client.queuedBytes > limits_.maxQueueBytes) {
        client.queuedBytes -= client.queue.front().message.size();
        client.queue.pop_front();
        ++dropped_;
        if (!std::exchange(client.isSlow, true)) {
            report(socket, kWarning,
                   QStringLiteral("this viewer is too slow: the oldest messages are dropped"));
        }
    }
}

// Data passed to the socket can no longer be dropped, so only a small amount is passed.
void FoxgloveServer::sendQueued(QWebSocket* socket, Client& client) {
    while (!client.queue.empty() && socket->bytesToWrite() < kMaxUnsent) {
        auto [subscription, message] = std::move(client.queue.front());
        client.queue.pop_front();
        client.queuedBytes -= message.size();
        qToLittleEndian(subscription, message.data() + 1);  // copies data shared with other viewers
        socket->sendBinaryMessage(message);
        ++sent_;
    }
}

}  // namespace tiller::live
