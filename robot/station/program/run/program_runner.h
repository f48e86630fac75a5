// SPDX-License-Identifier: MIT
#pragma once

// Runs a project program on the robot in place of the control program. This PC supervises the
// program: it ends within 250 ms of a stop, of the end of this process or of the loss of the connection.
// Monitors the running step, the time and the number of runs of each step.

#include <QObject>
#include <functional>
#include <optional>

#include "robot/control/motion.h"
#include "robot/station/link/hold_motion.h"
#include "robot/station/link/robot_session.h"
#include "robot/station/program/execution/run_gate.h"
#include "robot/station/program/execution/run_variables.h"
#include "robot/station/program/execution/step_log.h"
#include "robot/station/program/program_script.h"
#include "robot/station/program/run/start_step.h"

namespace tiller::program {

/// A script for the connected robot, or the reason why it cannot run.
struct RunPlan {
    project::Project project;  ///< project that contains the program
    QUuid program;
    QString name;  ///< name of the program
    ProgramScript script;
    QString obstacle;     ///< translated sentence; empty if the program can run
    double expected = 0;  ///< expected duration [s]; 0: unknown
    SpeedLimits limits;   ///< speed limits of the moves
};

/// Speed limits of a hold-to-run program, at which neither TCP nor elbow exceeds `tool` in a joint move.
/// tool     [m/s]
/// joint    [rad/s]
/// preview  preview of the same script from the current arm position, see stepsNotRun(). The limit then
///          applies to its joint moves. Null: the limit applies to any joint move and is much lower
SpeedLimits heldLimits(double tool, double joint, const SessionState& state, const Preview* preview);

/// The first collision of the preview as a sentence; empty without a collision.
QString collisionText(const project::Project& project, const ProgramScript& script, const Preview& preview);

/// Expected duration of a run with these speed limits [s], from the path of the preview.
/// speedFraction  speed slider, 0 ... 1
double slowedDuration(const Preview& preview, const SpeedLimits& limits, double speedFraction);

/// Options for a script that runs on the connected robot.
ScriptOptions optionsFor(const project::Project& project, const SessionState& state,
                         const SpeedLimits& limits = {});

/// Writes the script of the program for the connected robot. Reports as obstacle: a problem with the program,
/// a different model or TCP, a robot that cannot be moved now, an arm that is not at the position of `start`.
/// start  first step of the run; empty: the program runs from its beginning
RunPlan planRun(const project::Project& project, const QUuid& program, const SessionState& state,
                const SpeedLimits& limits = {}, const std::optional<StartStep>& start = {});

/// Why the program must not run without hold-to-run, as a sentence; empty if it may.
/// obstacle   RunPlan::obstacle
/// script     text of the script
/// preview    preview of the same script, started at the current arm position; null: no preview
/// previewed  text of the script of the preview
QString obstacleWithoutHold(const QString& obstacle, const QString& script, const SessionState& state,
                            const Preview* preview, const QString& previewed);

/// True if the arm is at the start position of the preview.
bool isAtStart(const Preview& preview, const SessionState& state);

class ProgramRunner : public QObject {
    Q_OBJECT

public:
    enum class State {
        Idle,     ///< no program has been started
        Sending,  ///< the control program is ending, and the program is being sent
        Running,
        Stopping,  ///< the program is ending, and control is being taken again
        Ended,
    };
    enum class End {
        Completed,
        StepFailed,
        Stopped,
        Unknown,         ///< robot data were missing at the end
        StoppedOnRobot,  ///< ended by the teach pendant or another client
        PausedOnRobot,   ///< held, and ended because the teach pendant or another client paused it
        Replaced,        ///< replaced by a program of another client
        Failed,
    };

    /// session  must outlive the runner
    explicit ProgramRunner(RobotSession& session, QObject* parent = nullptr);

    /// Starts the program of the plan.
    /// permitted  number of steps before the program pauses
    /// Errors  Cancelled with the obstacle of the plan, or if a program is running; those of
    ///         RobotSession::beginProgram()
    Result<RobotSession::MotionId> start(const RunPlan& plan, control::Holding holding,
                                         std::int32_t permitted = script::StepGate::kUnlimited);
    /// The motion of a button that runs the program while it is held. Near the maximum hold time, a program
    /// of unknown duration pauses before its next step, and the next press continues it.
    /// plan  called when the button is pressed, except to continue
    HoldMotion motion(std::function<RunPlan()> plan);
    /// True while a held program waits for the next press, with the arm at standstill.
    bool waitsForPress() const { return waitsForPress_ && isWaiting(); }
    void stop(control::StopCause cause);

    /// Pauses the program at standstill before its next step. The program stays active on the robot.
    void pause();
    /// No effect on a held program, which continues with the next press.
    void resume();
    /// Sets the steps before which a program pauses, also in called programs. New breakpoints take effect at
    /// the next start. A program that already waits at a removed breakpoint waits until resume(). Held
    /// programs do not pause, because another press would end the hold.
    void setBreakpoints(const QSet<QUuid>& steps);
    /// Runs one step of a waiting program, which then pauses again. No effect on a held program.
    void step();
    /// If true, the program ends at standstill before the next iteration of its outermost endless loop.
    void setEndsWithCycle(bool ends);

    /// Changes the value of a variable while the program waits. The program applies the change before it
    /// continues, and resume() and step() have no effect until variableChanged() reports the result.
    /// text    new value as typed
    /// Errors  InvalidArgument with a sentence
    Result<void> changeVariable(const QString& name, const QString& text);
    /// Why the value of a variable cannot be changed now, as a sentence; empty if it can.
    QString changeObstacle(const script::ProgramVariable& variable) const;
    /// Variables of the current or last run.
    const RunVariables& variables() const { return variables_; }

    bool endsWithCycle() const { return gate_.value().endsWithCycle; }

    /// True after pause() or step(), and while the program waits at a breakpoint.
    bool isPaused() const { return gate_.isPaused(log_); }
    /// True if the program is paused and has reached the next step.
    bool isWaiting() const { return state_ == State::Running && isPaused() && log_.isWaiting(); }
    /// True while the program is paused on the teach pendant or by another client, which must also resume it.
    bool isPausedOnRobot() const { return state_ == State::Running && log_.isPausedOnRobot(); }
    State state() const { return state_; }
    bool isActive() const { return state_ != State::Idle && state_ != State::Ended; }
    End end() const { return end_; }  ///< Valid in State::Ended.
    /// True if the program was stopped in log().lastStep(). After a loss of connection, later steps may have
    /// begun.
    bool isStoppedInLastStep() const;
    /// True if the program ended because its button was held longer than the maximum time.
    bool wasHeldTooLong() const;
    /// Describes the end in one sentence, with the step if the program did not complete.
    /// now  the project with later edits, for the numbers of the rows
    QString endText(const project::Project& now) const;
    /// The technical details of a failed run, for the log; empty otherwise.
    QString endDetails() const;
    /// Project and program of the current or last run, without later edits.
    const project::Project& project() const { return project_; }
    const QUuid& program() const { return program_; }
    const ProgramScript& script() const { return script_; }  ///< Script of the current or last run.
    const StepLog& log() const { return log_; }              ///< Steps of the current or last run.

Q_SIGNALS:
    void changed();
    /// A step has begun, or the program waits before it.
    /// step     number of the step
    /// isFirst  true for the first run of the step
    void stepBegan(int step, bool isFirst);
    /// The values of variables() have changed.
    void variablesChanged();
    /// The robot has confirmed a changed value, or has not confirmed it within two seconds.
    void variableChanged(const QString& text, bool isConfirmed);

private:
    RunPhase runPhase() const;
    void followVariables();
    void take(const SampleBatch& batch);
    void follow();
    void finish(const Result<control::MotionProgress>& progress);
    bool hold(RobotSession::MotionId id);
    std::int64_t pauseHeld();
    Result<RobotSession::MotionId> continueHeld();
    double moveSeconds() const;
    void setGate(const RunGate& gate);
    void passRemovedBreakpoint();

    RobotSession& session_;
    RobotSession::MotionId id_ = 0;
    State state_ = State::Idle;
    End end_ = End::Completed;
    control::StopCause cause_ = control::StopCause::None;
    Error error_;
    project::Project project_;
    QUuid program_;
    ProgramScript script_;
    StepLog log_;
    RunGate gate_;
    RunVariables variables_;
    QSet<QUuid> breakpoints_;
    double expected_ = 0;
    SpeedLimits limits_;
    control::Holding holding_ = control::Holding::Free;
    bool pausesHeld_ = false;     ///< true if the held program pauses at its next step
    bool waitsForPress_ = false;  ///< true if the held program has paused before its next step
    bool endsByPause_ = false;    ///< a held program was paused on the robot, which ends it
};

}  // namespace tiller::program
