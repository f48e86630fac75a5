// SPDX-License-Identifier: MIT
#pragma once

// What a robot sends, sent on while it comes: as a server that Foxglove and other viewers of its WebSocket protocol
// (foxglove.sdk.v1, messages in CDR) connect to, and as JSON in UDP datagrams, which PlotJuggler reads. It only tells;
// nothing that a viewer says reaches the robot. Off unless started, and for this machine only unless told otherwise.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/core/text.h"
#include "robot/receive/receiver.h"

namespace tiller::live {

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
};

struct LiveProgress {
    int viewers = 0;              ///< connected now
    std::uint64_t packets = 0;    ///< of the robot, sent on or at least looked at
    std::uint64_t messages = 0;   ///< to viewers
    std::uint64_t dropped = 0;    ///< messages a viewer was too slow for
    std::uint64_t datagrams = 0;  ///< that left this machine, or reached it
};

/// Owns the thread "tiller-live" (normal priority) with the sockets. What crosses: samples inward through a subscription.
/// Threads  start() and stop() from one, the rest from any
class LiveOutput {
public:
    LiveOutput();
    ~LiveOutput();  ///< stops
    LiveOutput(const LiveOutput&) = delete;
    LiveOutput& operator=(const LiveOutput&) = delete;

    /// Errors   FieldUnknown (the receiver does not follow it); AddressInvalid; Rejected: the port is taken, or is not
    ///          one that may be listened on
    Result<void> start(const LiveOptions& options, const receive::Receiver& receiver);
    void stop();  ///< Viewers are told that it is over.

    LiveProgress progress() const;  ///< Any thread
    std::uint16_t port() const;     ///< That the server listens on; 0 when there is none.

private:
    struct Worker;
    std::unique_ptr<Worker> d_;
};

}  // namespace tiller::live
