// SPDX-License-Identifier: MIT
#pragma once

// Stops any program on the controller immediately, regardless of whether the teach pendant or another PC
// started it. The command "stop program" is sent on an existing connection to the primary interface, and then
// on a new connection, because the controller may have dropped the existing connection without closing it.
// Motions of control::Controller are stopped by Controller::stop() instead.
//
// A robot in Local control refuses this command, like all commands on this interface; use the teach pendant in
// this case. Commands on a connection opened in Local control are refused even after the switch to Remote, so a
// refusal is followed by another attempt on a new connection. If the primary interface is disabled, use
// DashboardClient or RobotService::perform(StopProgram). Use both if the stop is critical.
//
// Source: Universal Robots client library ("stop program" on port 30001; a socket opened in Local stays
// read-only). It is not known whether a real controller in Local accepts this command as an exception.

#include <QString>
#include <memory>

#include "robot/core/clock.h"
#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "robot/script/script_client.h"

namespace tiller::script {

struct ProgramStopperOptions {
    QString host = QStringLiteral("127.0.0.1");
    int port = kPrimaryPort;
    const Clock* clock = &SteadyClock::shared();  ///< measures the duration of the repeated requests
};

/// Owns one thread with normal priority, started by start() and ended by end() or the destructor. The thread
/// opens the connection and reads from it. It retries after 0.5, 1, 2, 5, 5 ... s, or immediately while a
/// stop is requested. A mutex, never locked while waiting, protects the socket and the request.
class ProgramStopper {
public:
    explicit ProgramStopper(const ProgramStopperOptions& options);
    ~ProgramStopper();
    ProgramStopper(const ProgramStopper&) = delete;
    ProgramStopper& operator=(const ProgramStopper&) = delete;

    // Threads  any, for all functions. Blocks: only functions with a deadline, and end() for about 20 ms
    void start();  ///< Starts the thread.
    void end();    ///< Ends the thread.

    /// Requests the stop. If there is a connection, the command has been sent when this function returns. The
    /// command is repeated on a new connection about 10 ms later, and on further new connections every 0.3 s
    /// for two seconds, until the controller reports that no program is running.
    void requestStop();
    /// Cancels the request, so that a program started afterwards is not stopped.
    void withdraw();
    /// Waits for the outcome of the last request.
    /// Errors   RemoteControlRequired, Timeout (the program continues, or the controller does not respond),
    /// Cancelled (withdraw(), end(), or the deadline's token), or the reason why there is no connection:
    /// HostUnreachable, ConnectionRefused ...
    Result<void> waitUntilStopped(const Deadline& deadline) const;
    /// True while the outcome of the last request is pending.
    bool isUnderWay() const;
    Error error() const;  ///< The reason for the failure of the last stop.

    /// Opens a new connection, e.g. after the switch from Local to Remote.
    void reconnect();
    bool isConnected() const;

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace tiller::script
