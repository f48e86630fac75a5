// SPDX-License-Identifier: MIT
#pragma once

// Publishes live robot data through a WebSocket server for Foxglove and compatible viewers (foxglove.sdk.v1,
// messages in CDR), and as JSON in UDP datagrams for PlotJuggler. The output is read-only: viewers cannot
// send any request to the robot. It is disabled until start(), and by default accepts only viewers on this
// machine.

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/core/text.h"
#include "robot/receive/receiver.h"

namespace tiller::publish {
class Publisher;
}

namespace tiller::live {

/// Limits for viewers. They prevent a misbehaving viewer from exhausting the memory of this machine or
/// delaying other viewers.
struct LiveLimits {
    int maxViewers = 16;  ///< viewers with a subscription
    /// Maximum number of connections without a subscription, and of handshakes in progress. If exceeded, the
    /// oldest is closed.
    int maxIdleConnections = 32;
    qint64 maxHeaderBytes = 16 * 1024;    ///< HTTP header of the handshake [bytes]
    qint64 maxRequestBytes = 64 * 1024;   ///< incoming frame, and incoming message
    qint64 maxRequestRate = 1024 * 1024;  ///< incoming bytes of one viewer [1/s]
    /// Maximum size of the unsent messages of one viewer [bytes]; the oldest are dropped. Viewers share the messages,
    /// so 16 queues take little more memory than one.
    qint64 maxQueueBytes = 8 * 1024 * 1024;
    std::chrono::milliseconds handshakeTimeout{5'000};
    std::chrono::milliseconds stallTimeout{
        10'000};  ///< a viewer that reads nothing for this time is disconnected
};

struct LiveOptions {
    /// Address of the server; empty: no server. 0.0.0.0: all addresses of this machine.
    Text listenAddress = QStringLiteral("127.0.0.1");
    std::uint16_t port = 8765;  ///< 0: any free port; see port()
    /// Destination of the UDP datagrams; empty: none.
    Text udpAddress = {};
    std::uint16_t udpPort = 9870;  ///< default of PlotJuggler
    /// RTDE names of the published fields; empty: all fields of the receiver.
    std::vector<std::string> fields{};
    Text name = QStringLiteral("Tiller");  ///< server name displayed by viewers
    /// Additional origins of web pages and apps that may connect, e.g. "https://app.foxglove.dev", "file://",
    /// "null". Pages of this machine and clients without an Origin header (not a web page) are always allowed.
    std::vector<Text> allowedOrigins{};
    LiveLimits limits{};
};

struct LiveProgress {
    int viewers = 0;                 ///< number of connected viewers
    std::uint64_t packets = 0;       ///< processed packets from the robot
    std::uint64_t missed = 0;        ///< packets that were not sent because this machine is too slow
    std::uint64_t messages = 0;      ///< messages sent to viewers
    std::uint64_t dropped = 0;       ///< messages dropped because a viewer was too slow
    std::uint64_t datagrams = 0;     ///< datagrams sent successfully
    std::uint64_t disconnected = 0;  ///< connections closed because of a limit
    std::uint64_t refused = 0;       ///< connections refused because of their origin
    Text refusedOrigin = {};         ///< origin of the last refused connection
};

/// The sockets belong to the thread of a publisher. By default, each start creates a publisher.
/// Threads  start() and stop(): one thread. All others: any
class LiveOutput {
public:
    LiveOutput();
    /// publisher  shared with other sinks
    explicit LiveOutput(std::shared_ptr<publish::Publisher> publisher);
    ~LiveOutput();  ///< calls stop()
    LiveOutput(const LiveOutput&) = delete;
    LiveOutput& operator=(const LiveOutput&) = delete;

    /// Errors   FieldUnknown: the receiver does not subscribe to a field
    ///          AddressInvalid: an address or an allowed origin is malformed
    ///          Rejected: the port is in use, or the system does not permit it
    Result<void> start(const LiveOptions& options, const receive::Receiver& receiver);
    void stop();  ///< Closes all connections gracefully.

    LiveProgress progress() const;  ///< Threads: any
    std::uint16_t port() const;     ///< Port of the server; 0 without a server.

private:
    struct Private;
    std::shared_ptr<publish::Publisher> publisher_;  ///< null: each start creates one
    std::unique_ptr<Private> d_;
};

}  // namespace tiller::live
