// SPDX-License-Identifier: MIT
#pragma once

// Runs a program of a project through a Controller, without a RobotSession: for tiller-cli and Python.
// ProgramRunner does the same in a window.

#include <QSet>
#include <QStringList>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "robot/control/controller.h"
#include "robot/control/motion.h"
#include "robot/receive/receiver.h"
#include "robot/script/primary_client.h"
#include "robot/station/program/execution/run_gate.h"
#include "robot/station/program/execution/run_variables.h"
#include "robot/station/program/execution/step_log.h"
#include "robot/station/program/preview/preview.h"
#include "robot/station/program/program_script.h"

namespace tiller::program {

/// Fields of the receiver for checkForRobot() and ProgramExecution.
std::vector<std::string> executionFields();

/// A script for the connected robot.
struct CheckedProgram {
    ProgramScript script;
    JointPositions start;   ///< checked position of the arm [rad]
    QStringList obstacles;  ///< why the program must not run; empty if it may run
};

/// Writes the script and simulates its first ten minutes from the current position of the arm. Obstacles are
/// problems of the program, a robot with another model or TCP than the waypoints, and a simulated script
/// error, protective stop or collision.
/// options  options with the software version of the robot
/// robot    current sample with executionFields()
/// Threads  any. Blocks: up to a few seconds
CheckedProgram checkForRobot(const project::Project& project, const QUuid& program,
                             const ScriptOptions& options, const PreviewOptions& preview,
                             const receive::Sample& robot);

/// A running program. The robot ends it within 250 ms of the end of this process or of the loss of the
/// connection. Owns the threads "runner", which waits for the end of the program, and "monitor", which reads
/// the samples and the variables. Both have normal priority and share the members under the mutex.
/// Threads  any for all functions
class ProgramExecution {
public:
    enum class State {
        Starting,
        Running,
        Waiting,    ///< paused before a step
        Completed,  ///< the program reached its end
        Failed,     ///< a step failed and ended the program
        Stopped,    ///< ended by stop(), another client, the safety system or an error
    };
    struct Status {
        State state = State::Starting;
        int step = 0;                     ///< number of the running or waiting step; 0: none
        int lastStep = 0;                 ///< number of the last step that was running; 0: none
        int failedStep = 0;               ///< number of the step that ended the program; 0: none
        bool isPaused = false;            ///< the program pauses before its next step, or is waiting
        double seconds = 0;               ///< duration so far
        std::vector<StepTiming> timings;  ///< one per step; step number 1 is at index 0
    };

    /// Starts the program, unless the arm has left the checked position. Both threads end with the object.
    /// controller   must be in control and outlive the object
    /// samples      samples with executionFields()
    /// checked      result of checkForRobot(), without obstacles
    /// breakpoints  steps before which the program pauses
    /// stops        Controller::stops() when the user requested the run. After a further stop, the program
    ///              does not start. Empty: the number at the time of this call
    ProgramExecution(control::Controller& controller, receive::Subscription samples, CheckedProgram checked,
                     const QSet<QUuid>& breakpoints = {}, std::optional<std::uint64_t> stops = {});
    /// Stops the program. Blocks: until the control program runs again, or for a few seconds without a
    /// connection
    ~ProgramExecution();
    ProgramExecution(const ProgramExecution&) = delete;
    ProgramExecution& operator=(const ProgramExecution&) = delete;

    const ProgramScript& script() const { return script_; }
    Status status() const;
    bool isActive() const;  ///< True until the program has ended and the control program runs again.

    void pause();     ///< Pauses the program at standstill before its next step.
    void resume();    ///< Continues a paused program.
    void stepOnce();  ///< Runs one step of a waiting program.
    /// If true, the program ends at standstill before the next iteration of its outermost endless loop.
    void setEndsWithCycle(bool ends);
    void stop();  ///< Ends the program. The arm brakes. Blocks: never

    /// The global variables of the program, except those that Tiller adds, as the robot sends them ten times
    /// per second. After the end of the program, they have their last values.
    std::vector<script::ProgramVariable> variables() const;
    /// Changes a variable while the program waits before a step, and waits until the robot has confirmed the
    /// new value. The rest of the program was not simulated with this value.
    /// text     the new value as typed, see typedValue()
    /// Errors   InvalidArgument with a sentence if the change is not possible now. If the value may have
    ///          changed: Timeout without a confirmation within two seconds or before the deadline, Cancelled,
    ///          Stopped if the program continued or ended
    Result<void> changeVariable(const QString& name, const QString& text, const Deadline& deadline);

    /// Waits for the end of the program and until the control program runs again.
    /// Errors   Timeout, Cancelled (the program continues); ScriptError if a step failed; Stopped if the arm
    ///          was not at the checked position; those of control::Programs::runScript()
    Result<void> wait(const Deadline& deadline) const;

private:
    void run(const QString& text, std::uint64_t stops, receive::Subscription position);
    Result<void> checkPosition(receive::Subscription& position) const;
    void monitor();
    void changeGate(void (RunGate::*change)(const StepLog&));
    void sendGate();
    RunPhase runPhase() const;
    void followVariables();
    void endChange(const Result<void>& outcome);

    control::Controller& controller_;
    receive::Subscription samples_;
    const ProgramScript script_;
    const JointPositions start_;
    const CancelToken token_;
    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    StepLog log_;
    RunGate gate_;
    RunVariables variables_;
    bool isChanging_ = false;                 ///< a caller waits in changeVariable()
    std::optional<Result<void>> hasChanged_;  ///< result of the change for this caller
    control::Motion motion_;
    bool isStopped_ = false;
    std::optional<Result<void>> outcome_;  ///< set by the runner
    bool isEnded_ = false;                 ///< both threads have finished their work
    script::PrimaryClient primary_;        ///< receives the variables
    std::thread monitor_;
    std::thread runner_;
};

}  // namespace tiller::program
