// SPDX-License-Identifier: MIT
#pragma once

// Script of the user's own, and the coming and going of the control program.

#include <QString>

#include "robot/control/controller.h"
#include "robot/control/motion.h"
#include "robot/core/text.h"

namespace tiller::control {

/// Errors   of every call: NotInControl, UnsafeState, LinkLost, Timeout, Cancelled, ConnectionRefused,
///          HostUnreachable, RemoteControlRequired, ScriptError (with the line of the user's text and the
///          controller's words)
/// Threads  any. Blocks: at most until the deadline
class Programs {
public:
    explicit Programs(Controller& controller) : controller_(&controller) {}

    /// Runs the body of a function under the control program: stop and time-to-live hold for it too. The
    /// handle completes when it returns.
    /// name   of the function in messages: letters, digits and _, not beginning with a digit
    /// body   script lines without def and end: each block in it has an `end` of its own (else InvalidArgument). It must not
    ///        use names beginning with tiller_
    Result<Motion> startFunction(const Text& name, const Text& body, const Deadline& start,
                                 Holding holding = Holding::Free);

    /// Runs a whole program in place of the control program, waits for its end and takes control again.
    /// Controller::stop() and the deadline end it.
    /// program      `def ... end`, or lines, which run one after the other. It must not use names beginning
    ///              with tiller_heartbeat
    /// supervision  Heartbeat: a watchdog thread, sent in the program, ends it when the heartbeat of this
    ///              process stays away for 100 ms; the controller then brakes the arm as at the end of any
    ///              program. Unattended: the program is sent as it is; when this process is killed or the link
    ///              is lost, the arm moves on until the program is done
    Result<void> runScript(const Text& program, const Deadline& deadline,
                           Supervision supervision = Supervision::Heartbeat);

    /// Ends the control program; data go on coming. reupload() brings it back.
    Result<void> endControlProgram(const Deadline& deadline);
    /// Sends the control program anew, whether or not it runs.
    Result<void> reupload(const Deadline& deadline);
    /// Whether any program runs on the robot, by the newest data.
    bool isProgramRunning() const;

    /// The control program as software of this version gets it, to be read, or started by other means than
    /// takeControl().
    static QString controlProgram(const SoftwareVersion& version,
                                  RegisterRange registers = RegisterRange::Upper);

private:
    Controller* controller_;
};

}  // namespace tiller::control
