// SPDX-License-Identifier: MIT
#pragma once

// Stops whatever program runs on the controller, whoever started it, at once: "stop program" on a connection
// to the primary interface that is made beforehand and kept, so that nothing but the command itself has to go
// out; and on a new connection as well, because the controller may have forgotten the other one without a
// sign. What moves through control::Controller is stopped by Controller::stop(); this is for programs of
// others, from the teach pendant, another PC, or a program that was left running.
//
// A robot in Local control refuses it, as it refuses everything on this interface; the pendant stops it then.
// A connection that was made in Local stays refused after the switch to Remote, so a refusal is answered by
// one more try on a new connection. Software whose primary interface is switched off has DashboardClient and
// RobotService::perform(StopProgram) instead; who wants to be sure asks both ways.
//
// Source: Universal Robots client library ("stop program" on port 30001; a socket opened in Local stays
// read-only). Whether a real controller in Local makes an exception for this word is not known.

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
    const Clock* clock = &SteadyClock::shared();  ///< for how long a stop is asked for again
};

/// Thread: one, normal priority; started by start(), ended by end() or the destructor. It makes the
/// connection (again after 0.5, 1, 2, 5, 5 ... s, at once while a stop is asked for) and reads it; the socket
/// and what is asked for are shared with the callers under a mutex that nobody holds while waiting.
class ProgramStopper {
public:
    explicit ProgramStopper(const ProgramStopperOptions& options);
    ~ProgramStopper();
    ProgramStopper(const ProgramStopper&) = delete;
    ProgramStopper& operator=(const ProgramStopper&) = delete;

    // Threads  any, for everything below. Blocks: only where a deadline is given, and end() for some 20 ms.
    void start();
    void end();  ///< Ends the thread.

    /// Asks for the stop. Where there is a connection the command is on its way when this returns. It is sent
    /// on a new connection too, some 10 ms later, and again on a new one every 0.3 s, until the controller
    /// reports that no program runs, for two seconds.
    void requestStop();
    /// Asks no more: whoever starts a program now wants it to run.
    void withdraw();
    /// Waits for what became of the last request.
    /// Errors   RemoteControlRequired, Timeout (the program goes on, or the controller is mute), Cancelled
    ///          (withdraw(), end(), or the deadline's token); what kept the connection from being made:
    ///          HostUnreachable, ConnectionRefused ...
    Result<void> waitUntilStopped(const Deadline& deadline) const;
    /// What became of the last request, if that is known: nothing yet while it is under way.
    bool isUnderWay() const;
    Error error() const;  ///< Why the last stop failed.

    /// Makes the connection anew: after the switch from Local to Remote.
    void reconnect();
    bool isConnected() const;  ///< Any thread

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace tiller::script
