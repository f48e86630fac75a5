// SPDX-License-Identifier: MIT
#pragma once

// Forwards live robot data: through a server that Foxglove and other viewers of its WebSocket protocol
// (foxglove.sdk.v1, messages in CDR) connect to, and as JSON in UDP datagrams, which PlotJuggler reads. The output is
// read-only; no request of a viewer reaches the robot. It is off until started and by default serves this machine only.

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/core/text.h"
#include "robot/receive/receiver.h"

namespace tiller::live {

/// Limits for viewers. One hostile viewer can neither use up the memory of this machine nor delay the other viewers.
struct LiveLimits {
    int maxViewers = 16;  ///< with a subscription
    /// Connections without a subscription, and handshakes in progress (each). A new one replaces the oldest.
    int maxIdleConnections = 32;
    qint64 maxHeaderBytes = 16 * 1024;    ///< HTTP header of the handshake
    qint64 maxRequestBytes = 64 * 1024;   ///< incoming frame, and incoming message
    qint64 maxRequestRate = 1024 * 1024;  ///< incoming bytes of one viewer [1/s]
    /// Unsent messages of one viewer; the oldest are dropped. Viewers share the messages, so that 16 queues take little
    /// more memory than one.
    qint64 maxQueueBytes = 8 * 1024 * 1024;
    std::chrono::milliseconds handshakeTimeout{5'000};
    std::chrono::milliseconds stallTimeout{
        10'000};  ///< a viewer that reads nothing for so long is disconnected
};

struct LiveOptions {
    /// The server's own address; empty: no server. 0.0.0.0: every one of this machine's.
    Text listenAddress = QStringLiteral("127.0.0.1");
    std::uint16_t port = 8765;  ///< 0: one that is free; port() tells
    /// Where the datagrams go; empty: none are sent.
    Text udpAddress = {};
    std::uint16_t udpPort = 9870;  ///< PlotJuggler's
    /// Sent on, by their RTDE names; empty: all that the receiver follows.
    std::vector<std::string> fields{};
    Text name = QStringLiteral("Tiller");  ///< what viewers show
    /// Origins of web pages and apps that may connect, in addition to those of this machine: "https://app.foxglove.dev",
    /// "file://", "null". A viewer without an Origin header is no web page and is always allowed.
    std::vector<Text> allowedOrigins{};
    LiveLimits limits{};
};

struct LiveProgress {
    int viewers = 0;                 ///< connected now
    std::uint64_t packets = 0;       ///< of the robot, sent on or at least looked at
    std::uint64_t messages = 0;      ///< to viewers
    std::uint64_t dropped = 0;       ///< messages that a viewer was too slow for
    std::uint64_t datagrams = 0;     ///< that left this machine, or reached it
    std::uint64_t disconnected = 0;  ///< connections closed because of a limit
    std::uint64_t refused = 0;       ///< connections of web pages that are not allowed
    Text refusedOrigin = {};         ///< of the last refused connection
};

/// Owns the thread "tiller-live" (normal priority) with the sockets. What crosses: samples inward through a subscription.
/// Threads  start() and stop() from one, the rest from any
class LiveOutput {
public:
    LiveOutput();
    ~LiveOutput();  ///< stops
    LiveOutput(const LiveOutput&) = delete;
    LiveOutput& operator=(const LiveOutput&) = delete;

    /// Errors   FieldUnknown: the receiver does not follow a field
    ///          AddressInvalid: an address or an allowed origin is malformed
    ///          Rejected: the port is in use, or may not be listened on
    Result<void> start(const LiveOptions& options, const receive::Receiver& receiver);
    void stop();  ///< Viewers are told that it is over.

    LiveProgress progress() const;  ///< Any thread
    std::uint16_t port() const;     ///< That the server listens on; 0 when there is none.

private:
    struct Worker;
    std::unique_ptr<Worker> d_;
};

}  // namespace tiller::live
