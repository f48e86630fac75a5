// SPDX-License-Identifier: MIT
#pragma once

// Client of the primary interface (port 30001): receives controller messages and the configuration of the
// arm.

#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "robot/core/clock.h"
#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "robot/core/text.h"
#include "robot/script/controller_message.h"

namespace tiller::script {

struct PrimaryClientOptions {
    Text host = QStringLiteral("127.0.0.1");
    int port = 30001;
    const Clock* clock = &SteadyClock::shared();
    bool reconnect = true;            ///< with delays of 0.5, 1, 2, 5, 5 ... s
    std::size_t maxMessages = 10000;  ///< buffered messages; if exceeded, the oldest are dropped and counted
};

/// Owns one thread with normal priority, started by start() and ended by stop() or the destructor. The thread
/// reads the socket; a mutex protects messages and states.
class PrimaryClient {
public:
    explicit PrimaryClient(const PrimaryClientOptions& options);
    ~PrimaryClient();
    PrimaryClient(const PrimaryClient&) = delete;
    PrimaryClient& operator=(const PrimaryClient&) = delete;

    // Threads  any, for all functions. Blocks: only functions with a deadline, and stop() for about 20 ms
    void start();  ///< Starts the thread.
    void stop();   ///< Ends the thread. No effect if it is not running.

    /// Waits for the first robot state.
    /// Errors   the reason why there is no connection: HostUnreachable, ConnectionRefused, Timeout ...
    Result<void> waitForState(const Deadline& deadline) const;
    bool isConnected() const;
    /// The reason why there is no connection; code None if connected or if no attempt has been made yet.
    Error connectionError() const;

    /// Makes the thread send "stop program", which ends the running or paused program, within about 5 ms. No
    /// effect without a connection. Real-time: yes
    void requestProgramStop();

    /// Returns all messages since the last call, oldest first.
    std::vector<ControllerMessage> takeMessages();
    PrimaryState state() const;  ///< The newest state.
    /// Available after the first robot state of a connection.
    std::optional<RobotConfiguration> configuration() const;
    std::uint64_t droppedMessages() const;  ///< Number of messages dropped because the buffer was full.
    /// Number of packages skipped because they violate the protocol.
    std::uint64_t malformedPackages() const;

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace tiller::script
