// SPDX-License-Identifier: MIT
#pragma once

// The server's side of the Foxglove WebSocket protocol, version 1, as far as one that only tells needs it. Source:
// github.com/foxglove/ws-protocol, docs/spec.md. Private to this room.

#include <QHash>
#include <QObject>
#include <QWebSocketServer>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "robot/core/result.h"

class QWebSocket;

namespace tiller::live {

struct LiveChannel {
    std::uint32_t id = 0;
    std::string topic{};
    std::string type{};        ///< "sensor_msgs/msg/JointState"
    std::string definition{};  ///< ros2msg
};

/// Threads  that of its event loop
class FoxgloveServer : public QObject {
public:
    explicit FoxgloveServer(const QString& name);
    ~FoxgloveServer() override;

    Result<void> listen(const QString& address, std::uint16_t port);
    std::uint16_t port() const { return server_.serverPort(); }
    int viewers() const { return static_cast<int>(clients_.size()); }
    std::uint64_t sent() const { return sent_; }
    std::uint64_t dropped() const { return dropped_; }

    /// In place of one of the same topic.
    void advertise(const LiveChannel& channel);
    /// Whether anybody wants it: what nobody wants need not be made.
    bool isWanted(std::uint32_t channel) const { return wanted_.value(channel, 0) > 0; }
    void send(std::uint32_t channel, std::uint64_t timeNs, const std::string& message);

private:
    struct Client {
        QHash<std::uint32_t, std::uint32_t>
            subscriptions;  ///< number of the channel, by the client's own number
        bool isSlow = false;
    };
    void welcome();
    void hear(QWebSocket* socket, const QString& text);
    void forget(QWebSocket* socket);
    void subscribe(QWebSocket* socket, Client& client, std::uint32_t id, std::uint32_t channel);
    void unsubscribe(Client& client, std::uint32_t id);

    QString name_;
    QString session_;
    QWebSocketServer server_;
    std::vector<LiveChannel> channels_;
    QHash<QWebSocket*, Client> clients_;
    QHash<std::uint32_t, int> wanted_;
    std::uint64_t sent_ = 0;
    std::uint64_t dropped_ = 0;
};

}  // namespace tiller::live
