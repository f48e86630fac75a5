// SPDX-License-Identifier: MIT
#pragma once

// Runs user scripts, and ends and restarts the control program.

#include <QString>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "robot/control/controller.h"
#include "robot/control/motion.h"
#include "robot/core/text.h"
#include "robot/script/step_gate.h"

namespace tiller::control {

/// Options for running a complete program: see Programs::runScript().
struct ScriptTerms {
    Supervision supervision = Supervision::Heartbeat;
    /// Held: the program also ends if the motion is not refreshed for 100 ms or if the program is paused.
    /// Requires Supervision::Heartbeat.
    Holding holding = Holding::Free;
    /// If set, the program can call the functions of script::stepGateScript(), with this initial gate.
    /// Motion::setGate() changes the gate. Requires Supervision::Heartbeat.
    std::optional<script::StepGate> gate = {};
    /// Global variables of the program that the gate can change.
    std::vector<script::GateVariable> variables = {};
    /// The program does not start if the number of stops (Controller::stops()) differs from this value.
    std::optional<std::uint64_t> stops = {};
    /// Called once in the calling thread, immediately before the program is sent, with the motion that
    /// represents the program. Ending this motion ends the program. Returns false to cancel the start. Not
    /// called for an unattended program.
    std::function<bool(const Motion& run)> starting = {};
    /// Called in the calling thread after the script has ended without an error. If it returns false, control
    /// is not taken again, e.g. because the script was stopped on the robot.
    std::function<bool()> regainsControl = {};
    /// If false, control is lost when the script ended because data or heartbeats did not arrive (LinkLost).
    bool regainsAfterDataGap = true;
};

/// Errors   of every call: NotInControl, UnsafeState, LinkLost, Timeout, Cancelled, ConnectionRefused,
///          HostUnreachable, RemoteControlRequired, ScriptError (with the line number in the user's text and
///          the controller's message)
/// Threads  any. Blocks: at most until the deadline
class Programs {
public:
    explicit Programs(Controller& controller) : controller_(&controller) {}

    /// Runs a function body inside the control program, with the same stop functions and heartbeat timeout.
    /// The handle completes when the function returns.
    /// name   of the function in messages: letters, digits and _, not starting with a digit
    /// body   script lines without def and end; each block must be closed by its own `end` (else
    ///        InvalidArgument). Names starting with tiller_ are reserved
    Result<Motion> startFunction(const Text& name, const Text& body, const Deadline& start,
                                 Holding holding = Holding::Free);

    /// Runs a complete program instead of the control program, waits for its end and takes control again.
    /// Controller::stop() or an expired deadline ends the program.
    /// program      `def ... end`, or a sequence of lines. Names starting with tiller_heartbeat are reserved
    /// supervision  Heartbeat: an inserted watchdog thread ends the program after 100 ms without a heartbeat
    ///              of this process; the controller then decelerates as at the end of any program.
    ///              Unattended: the program is sent unchanged; if this process crashes or the connection is
    ///              lost, the arm moves until the program is complete
    Result<void> runScript(const Text& program, const Deadline& deadline,
                           Supervision supervision = Supervision::Heartbeat);
    /// Like runScript() above.
    /// Errors       also Stopped, with the cause, if the motion ended before the program
    Result<void> runScript(const Text& program, const Deadline& deadline, const ScriptTerms& terms);

    /// Ends the control program. Robot data continue to arrive. reupload() starts the program again.
    Result<void> endControlProgram(const Deadline& deadline);
    /// Sends the control program again, even if it is running.
    Result<void> reupload(const Deadline& deadline);
    /// True if any program is running on the robot, according to the newest data.
    bool isProgramRunning() const;

    /// Text of the control program for this software version, e.g. for review or to start it without
    /// takeControl().
    static QString controlProgram(const SoftwareVersion& version,
                                  RegisterRange registers = RegisterRange::Upper);

private:
    Controller* controller_;
};

}  // namespace tiller::control
