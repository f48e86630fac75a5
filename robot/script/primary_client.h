// SPDX-License-Identifier: MIT
#pragma once

// Listens to the primary interface (port 30001): messages of the controller, and the arm's own dimensions.

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
    bool reconnect = true;            ///< after 0.5, 1, 2, 5, 5 ... s
    std::size_t maxMessages = 10000;  ///< kept until taken; then the oldest go and are counted
};

/// Thread: one, normal priority; started by start(), ended by stop() or the destructor. It reads the socket;
/// messages and states cross to the callers under a mutex.
class PrimaryClient {
public:
    explicit PrimaryClient(const PrimaryClientOptions& options);
    ~PrimaryClient();
    PrimaryClient(const PrimaryClient&) = delete;
    PrimaryClient& operator=(const PrimaryClient&) = delete;

    // Threads  any, for everything below. Blocks: only where a deadline is given, and stop() for some 20 ms.
    void start();
    void stop();  ///< Ends the thread. Harmless when not running.

    /// Waits until the first robot state has come.
    /// Errors   what kept the connection from working: HostUnreachable, ConnectionRefused, Timeout ...
    Result<void> waitForState(const Deadline& deadline) const;
    bool isConnected() const;  ///< Any thread
    /// Why there is no connection now; code None when there is one or none was tried.
    Error connectionError() const;

    /// Lets its thread tell the controller to stop the program that runs or is paused, within some 5 ms. Lost
    /// when there is no connection. Real-time: yes
    void requestProgramStop();

    /// All messages since the last call, oldest first.
    std::vector<ControllerMessage> takeMessages();
    PrimaryState state() const;  ///< The newest. Any thread
    /// From the first robot state of a connection on.
    std::optional<RobotConfiguration> configuration() const;
    std::uint64_t droppedMessages() const;  ///< For want of space. Any thread
    /// Packages that were not what the protocol says, and were skipped.
    std::uint64_t malformedPackages() const;

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace tiller::script
