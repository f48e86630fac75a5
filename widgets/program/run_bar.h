// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The buttons that run the program of the Program tab: "Run (hold)", "Move to start (hold)", and "Run", which
// also stops a program that runs without hold-to-run. After a release, "Run (hold)" continues the program.
// "Pause", "Step" and "Finish cycle" control the running program. "Start from here" makes the selected step
// the first step. HoldRules determines when a held motion ends.

#include <QWidget>
#include <functional>
#include <optional>

#include "robot/station/link/move_time.h"
#include "robot/station/program/run/continue_step.h"
#include "robot/station/program/run/program_runner.h"

class QPushButton;

namespace tiller {

class HoldToRunButton;
class ProjectDocument;
struct HoldPolicy;

class RunBar : public QWidget {
    Q_OBJECT

public:
    /// policy     hold policy of the window
    /// heldSpeed  returns the maximum speed of held motions
    /// All references must outlive the bar.
    RunBar(RobotSession& session, HoldPolicy& policy, const ProjectDocument& document,
           std::function<HeldSpeed()> heldSpeed, QWidget* parent = nullptr);
    ~RunBar() override;

    /// Sets the program and its latest script for the connected robot. Selecting a different program ends a
    /// held run.
    void setProgram(const QUuid& program, const program::ProgramScript& script);
    /// Sets the preview of this script; empty if there is none.
    void setPreview(const program::ProgramScript& script, const std::optional<program::Preview>& preview);
    /// Sets the step at which the stopped program can continue. While that step is selected, "Start from
    /// here" continues the program. Without a start step, the program cannot continue.
    void setContinuation(const program::Continuation& continuation);
    /// The step at which the last run was stopped, and the kind of the stop. Step 0 means unknown.
    struct StoppedAt {
        int step = 0;
        program::StopKind kind = program::StopKind::Operator;
    };
    StoppedAt stoppedAt() const;
    /// True if digital outputs have changed since the last run was stopped.
    bool hasOtherOutputs() const { return hasOtherOutputs_; }
    /// True if the stopped program can continue.
    bool offersContinuation() const { return continuation_.start || continuesStop_; }
    /// Sets the selected step; null if there is none, or more than one.
    void setSelectedStep(const QUuid& step);
    /// The step at which the program starts; empty for the beginning of the program.
    const std::optional<program::StartStep>& startStep() const { return startStep_; }
    /// The inputs of the connected robot that are on, for a preview.
    std::vector<program::InputChange> inputs() const;
    void clearStartStep();
    /// After a held run was stopped in a step that can continue where the arm is, makes it the first step of
    /// the next run. After a completed run, the next run starts from the beginning again. Call this when a
    /// run has ended.
    /// Returns  why the program cannot continue, as a sentence; empty if it can, or if the run was not held
    QString keepPlace();
    void showSpeed();
    const program::ProgramRunner& runner() const { return runner_; }
    /// Changes a variable of the waiting program. Emits refused() if this is not possible.
    /// text  as typed
    void changeVariable(const QString& name, const QString& text);
    void setBreakpoints(const QSet<QUuid>& steps) { runner_.setBreakpoints(steps); }
    /// True while a held program runs whose joint moves use the speed limit for unknown paths; see
    /// heldLimits().
    bool isSlowed() const { return isHeld_ && isSlowed_ && runner_.isActive(); }
    /// True while a program runs without hold-to-run.
    bool runsFreely() const { return runner_.isActive() && !isHeld_; }
    void stop(control::StopCause cause);

Q_SIGNALS:
    /// A press had no effect for this reason.
    void refused(const QString& reason);
    /// The user has changed startStep(), so script and preview are out of date.
    void startStepChanged();
    /// The state or the running step of the program has changed.
    void runChanged();
    /// The robot has lost power, or its outputs have changed, since the last run.
    void stopChanged();
    /// See ProgramRunner::stepBegan().
    void stepBegan(int step, bool isFirst);

protected:
    /// Keeps the focus on a button that is disabled. Otherwise, Qt would move the focus to a field of the
    /// step.
    bool focusNextPrevChild(bool next) override;

private:
    /// name  object name of the question
    void ask(const QString& name, const QString& title, const QString& text, const QString& accept,
             const std::function<void()>& accepted);
    /// Continues a paused program. Asks first if a variable was changed in this run.
    void continueRun(const std::function<void()>& proceed);
    /// Asks for confirmation of a run without hold-to-run if the preview did not run all steps of the script.
    void askToRun(std::int32_t permitted, const QString& script);
    /// True if the preview of the current script ran every step that moves the arm or takes time.
    bool isPreviewedInFull() const;
    program::SpeedLimits limits() const;
    program::RunPlan plan(const program::SpeedLimits& limits) const;
    JointPositions start() const;
    MoveRequest moveToStart() const;
    HoldMotion startMotion();
    HoldMotion heldMotion();
    void runOrStop();
    void run(std::int32_t permitted);
    void pauseOrResume();
    void stepOnce();
    void toggleStartStep();
    bool continues() const;
    void follow(const SessionState& state);
    void followOutputs(const SessionState& state);
    QString programObstacle() const;
    QString runObstacle() const;
    void updateAvailability();
    void updateGateKeys();
    void showRun();

    RobotSession& session_;
    const ProjectDocument& document_;
    std::function<HeldSpeed()> heldSpeed_;
    program::ProgramRunner runner_;
    HeldSpeed startedAt_;    ///< maximum speed at the start of the held run
    bool isSlowed_ = false;  ///< true if the held run uses the speed limit for unknown paths
    bool isHeld_ = false;    ///< true if releasing the button ends the current run
    QUuid program_;
    program::ProgramScript script_;
    bool hasChange_ = false;  ///< true if a variable was changed in a run without hold, and the user has not
                              ///< confirmed the change
    bool ranEveryStep_ = false;  ///< true if preview_ ran every step; cached because a program can have many
                                 ///< steps
    QString confirmedScript_;  ///< script that the user has permitted to run although the preview did not run
                               ///< every step
    program::ProgramScript previewed_;
    std::optional<program::Preview> preview_;
    QUuid selected_;
    program::Continuation continuation_;
    bool hasLostPower_ = false;                    ///< true if power was lost since the end of the last run
    std::optional<std::uint64_t> stoppedOutputs_;  ///< digital outputs at the end of the last run
    bool hasOtherOutputs_ = false;
    std::optional<program::StartStep> startStep_;
    bool continuesStop_ = false;  ///< true if startStep_ is the step in which a held run was stopped
    MoveRequest startMove_;       ///< current motion to the start position
    HoldToRunButton* hold_;
    HoldToRunButton* start_;
    QPushButton* run_;
    QPushButton* pause_;
    QPushButton* step_;
    QPushButton* finish_;
    QPushButton* from_;
};

}  // namespace tiller
