// SPDX-License-Identifier: MIT
#pragma once

// The server side of the Foxglove WebSocket protocol, version 1, for a server that only publishes. Source:
// github.com/foxglove/ws-protocol, docs/spec.md. Private to this module.

#include <QHash>
#include <QObject>
#include <QTcpServer>
#include <QTimer>
#include <QWebSocketServer>
#include <chrono>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/live/detail/allowed_origins.h"
#include "robot/live/live_output.h"

class QTcpSocket;
class QWebSocket;

namespace tiller::live {

struct LiveChannel {
    std::uint32_t id = 0;
    std::string topic{};
    std::string type{};        ///< e.g. "sensor_msgs/msg/JointState"
    std::string definition{};  ///< ros2msg
};

/// Threads  the thread of its event loop
class FoxgloveServer : public QObject {
public:
    FoxgloveServer(const QString& name, AllowedOrigins origins, const LiveLimits& limits);
    ~FoxgloveServer() override;

    Result<void> listen(const QString& address, std::uint16_t port);
    std::uint16_t port() const { return listener_.serverPort(); }
    int viewers() const { return static_cast<int>(clients_.size()); }
    std::uint64_t sent() const { return sent_; }
    std::uint64_t dropped() const { return dropped_; }
    std::uint64_t disconnected() const { return disconnected_; }
    std::uint64_t refused() const { return refused_; }
    const QString& refusedOrigin() const { return refusedOrigin_; }

    /// Replaces a channel with the same topic.
    void advertise(const LiveChannel& channel);
    /// True if any viewer has subscribed to the channel.
    bool isWanted(std::uint32_t channel) const { return wanted_.value(channel, 0) > 0; }
    void send(std::uint32_t channel, std::uint64_t timeNs, const std::string& message);

private:
    using Time = std::chrono::steady_clock::time_point;

    /// Number of bytes received through one TCP connection. Qt reads the bytes between two updates of
    /// `unread`.
    struct Incoming {
        qint64 unread = 0;
        qint64 inWindow = 0;
        Time windowBegin{};
    };
    struct Handshake {
        QTcpSocket* socket = nullptr;
        std::shared_ptr<Incoming> incoming;
    };
    /// A message for one viewer. The queues of all viewers share the bytes.
    struct Queued {
        std::uint32_t subscription = 0;
        QByteArray message{};
    };
    struct Client {
        QHash<std::uint32_t, std::uint32_t>
            subscriptions{};  ///< channel for each subscription id of the client
        std::deque<Queued> queue{};
        qint64 queuedBytes = 0;
        Time waitingSince{};  ///< time since which no byte could be sent
        std::uint64_t order = 0;
        bool isSlow = false;
        bool isClosing = false;
    };

    void accept();
    void welcome();
    void receive(QWebSocket* socket, const QString& text);
    void countIncoming(QTcpSocket* socket, Incoming& incoming);
    void subscribe(QWebSocket* socket, Client& client, std::uint32_t id, std::uint32_t channel);
    void unsubscribe(Client& client, std::uint32_t id);
    void report(QWebSocket* socket, int level, const QString& message);
    void closeOldestIdleClient();
    void closeStalledClients();
    void closeIfUnread(QWebSocket* socket);
    void disconnectLater(QWebSocket* socket, const QString& reason);
    void forget(QWebSocket* socket);
    void enqueue(QWebSocket* socket, Client& client, Queued next);
    void sendQueued(QWebSocket* socket, Client& client);
    int subscribedViewers() const;

    QString name_;
    QString session_;
    AllowedOrigins origins_;
    LiveLimits limits_;
    QTcpServer listener_;
    QWebSocketServer upgrader_;
    QTimer stallTimer_;
    std::deque<Handshake> handshakes_;  ///< oldest first
    std::vector<LiveChannel> channels_;
    QHash<QWebSocket*, Client> clients_;
    QHash<std::uint32_t, int> wanted_;
    std::uint64_t accepted_ = 0;
    std::uint64_t sent_ = 0;
    std::uint64_t dropped_ = 0;
    std::uint64_t disconnected_ = 0;
    std::uint64_t refused_ = 0;
    QString refusedOrigin_;
};

}  // namespace tiller::live
