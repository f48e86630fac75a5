// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/program/run_bar.h"

#include <QHBoxLayout>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "robot/station/document/project_document.h"
#include "robot/station/link/obstacles.h"
#include "robot/station/program/recover/steps_not_reached.h"
#include "robot/station/program/step_field.h"
#include "robot/station/text/texts.h"
#include "widgets/common/enter_key.h"
#include "widgets/hold/hold_to_run_button.h"

namespace tiller {

namespace {

HoldToRunButton* holdKey(const char* name, const QString& text, const QString& accessibleName,
                         const QString& toolTip, HoldPolicy& policy) {
    auto* key = new HoldToRunButton(text, policy);
    key->setObjectName(QLatin1String(name));
    key->setAccessibleName(accessibleName);
    key->setToolTip(toolTip);
    return key;
}

QPushButton* keyNamed(const char* name, const QString& text) {
    auto* key = new EnterKey(text);
    key->setObjectName(QLatin1String(name));
    key->setAutoDefault(false);
    return key;
}

/// A button that keeps its size when its text changes to one of the other texts.
class ChangingKey : public EnterKey {
public:
    ChangingKey(const char* name, const QString& text, const QStringList& others)
        : EnterKey(text), others_(others) {
        setObjectName(QLatin1String(name));
        setAutoDefault(false);
    }
    QSize sizeHint() const override {
        QSize size = EnterKey::sizeHint();
        for (const QString& other : others_) {
            size = size.expandedTo(EnterKey(other).sizeHint());
        }
        return size;
    }

private:
    QStringList others_;
};

/// Setting a tooltip sends an event even if the text is unchanged, so set it only after a change.
void setToolTipOf(QPushButton& key, const QString& text) {
    if (key.toolTip() != text) {
        key.setToolTip(text);
    }
}

void setReason(QPushButton& key, const QString& reason, const QString& toolTip) {
    key.setEnabled(reason.isEmpty());
    setToolTipOf(key, reason.isEmpty() ? toolTip : reason);
}

/// Text of an error at the start of a motion. Some errors contain a sentence for the operator. The text of
/// the other errors is derived from the code.
QString reasonOf(const Error& error) {
    return error.code == ErrorCode::Cancelled || error.code == ErrorCode::NoSolution ||
                   error.code == ErrorCode::NotInControl
               ? error.context
               : texts::errorText(error);
}

}  // namespace

RunBar::RunBar(RobotSession& session, HoldPolicy& policy, const ProjectDocument& document,
               std::function<HeldSpeed()> heldSpeed, QWidget* parent)
    : QWidget(parent)
    , session_(session)
    , document_(document)
    , heldSpeed_(std::move(heldSpeed))
    , runner_(session)
    , hold_(holdKey(
          "program.runHold", tr("Run (hold)"), tr("Run the program (hold)"),
          tr("Runs the program while the button is held, no faster than the jog speed. The program ends when "
             "you release the button. If the arm is not at the start position of a complete preview, joint "
             "moves are slower so that no possible path exceeds the speed limit."),
          policy))
    , start_(holdKey("program.moveToStart", tr("Move to start (hold)"),
                     tr("Move to the start position (hold)"),
                     tr("Moves all joints to the start position while the button is held"), policy))
    , run_(new ChangingKey("program.run", tr("Run"), {tr("Stop")}))
    , pause_(new ChangingKey("program.pause", tr("Pause"), {tr("Resume")}))
    , step_(keyNamed("program.step", tr("Step")))
    , finish_(keyNamed("program.finishCycle", tr("Finish cycle")))
    , from_(new ChangingKey("program.fromHere", tr("Start from here"),
                            {tr("From step %1 ✕").arg(999), tr("Continue at %1").arg(999)})) {
    setObjectName("program.runBar");
    auto* begin = new QHBoxLayout;
    begin->setSpacing(8);
    begin->addWidget(hold_, 1);
    begin->addWidget(start_, 1);
    begin->addWidget(run_);
    auto* gate = new QHBoxLayout;
    gate->setSpacing(8);
    for (QPushButton* each : {pause_, step_, finish_, from_}) {
        gate->addWidget(each, 1);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addLayout(begin);
    layout->addLayout(gate);
    finish_->setCheckable(true);
    from_->setCheckable(true);
    hold_->setMotion(heldMotion());
    start_->setMotion(startMotion());
    for (HoldToRunButton* key : {hold_, start_}) {
        connect(&key->guard(), &HoldGuard::refused, this,
                [this](const Error& error) { Q_EMIT refused(reasonOf(error)); });
    }
    connect(run_, &QPushButton::clicked, this, &RunBar::runOrStop);
    connect(pause_, &QPushButton::clicked, this, &RunBar::pauseOrResume);
    connect(step_, &QPushButton::clicked, this, &RunBar::stepOnce);
    connect(from_, &QPushButton::clicked, this, &RunBar::toggleStartStep);
    connect(finish_, &QPushButton::toggled, &runner_, &program::ProgramRunner::setEndsWithCycle);
    connect(&runner_, &program::ProgramRunner::changed, this, &RunBar::showRun);
    connect(&runner_, &program::ProgramRunner::stepBegan, this, &RunBar::stepBegan);
    connect(&runner_, &program::ProgramRunner::variableChanged, this, &RunBar::updateGateKeys);
    connect(&session_, &RobotSession::stateChanged, this, &RunBar::follow);
    updateAvailability();
}

RunBar::~RunBar() {
    stop(control::StopCause::WindowClosed);
}

void RunBar::setProgram(const QUuid& program, const program::ProgramScript& script) {
    if (program != program_) {
        stop(control::StopCause::SelectionChanged);
        if (runner_.waitsForPress()) {
            runner_.stop(control::StopCause::SelectionChanged);
        }
        clearStartStep();
    }
    program_ = program;
    script_ = script;
    updateAvailability();
    showSpeed();
}

void RunBar::setPreview(const program::ProgramScript& script,
                        const std::optional<program::Preview>& preview) {
    previewed_ = script;
    preview_ = preview;
    ranEveryStep_ = preview && program::stepsNotRun(document_.project(), script, *preview).empty();
    updateAvailability();
}

bool RunBar::isPreviewedInFull() const {
    return preview_ && previewed_.text == script_.text && ranEveryStep_;
}

program::SpeedLimits RunBar::limits() const {
    const HeldSpeed held = heldSpeed_();
    return program::heldLimits(held.tcp, held.joint, session_.state(),
                               isPreviewedInFull() ? &*preview_ : nullptr);
}

program::RunPlan RunBar::plan(const program::SpeedLimits& limits) const {
    program::RunPlan plan =
        program::planRun(document_.project(), program_, session_.state(), limits, startStep_);
    if (isPreviewedInFull() && preview_->completed && !preview_->isEndless) {
        plan.expected = program::slowedDuration(*preview_, limits, session_.state().speedFraction);
    }
    return plan;
}

JointPositions RunBar::start() const {
    return startStep_                            ? startStep_->q
           : preview_ && !preview_->path.empty() ? preview_->path.front().q
                                                 : program::startPosition(document_.project(), script_);
}

MoveRequest RunBar::moveToStart() const {
    MoveRequest move;
    move.q = start();
    move.speed = session_.limits().jointSpeed;
    move.acceleration = session_.limits().jointAcceleration;
    move.toProject = true;
    return slowedTo(heldSpeed_(), move, session_.state());
}

HoldMotion RunBar::heldMotion() {
    HoldMotion motion = runner_.motion([this] {
        isHeld_ = true;
        startedAt_ = heldSpeed_();
        isSlowed_ =
            !isPreviewedInFull() || !preview_->completed || !program::isAtStart(*preview_, session_.state());
        program::RunPlan planned = plan(limits());
        if (planned.obstacle.isEmpty() && preview_ && previewed_.text == script_.text) {
            planned.obstacle = program::collisionText(document_.project(), script_, *preview_);
        }
        return planned;
    });
    // The speed limits are part of the script that waits on the robot.
    motion.begin = [this, begin = std::move(motion.begin)]() -> Result<HoldMotion::Id> {
        const HeldSpeed now = heldSpeed_();
        if (runner_.waitsForPress() && (now.tcp < startedAt_.tcp || now.joint < startedAt_.joint)) {
            return Error{ErrorCode::Cancelled,
                         tr("The program started with a jog speed of %1 and cannot continue at a lower "
                            "speed. Select this speed again, or stop the program.")
                             .arg(program::numberText(startedAt_.tcp, program::Unit::Speed)),
                         {}};
        }
        return begin();
    };
    return motion;
}

HoldMotion RunBar::startMotion() {
    return {
        .begin =
            [this] {
                startMove_ = moveToStart();
                return session_.beginMove(startMove_);
            },
        .hold = [this](HoldMotion::Id id) { return session_.hold(id); },
        .end = [this](HoldMotion::Id id, control::StopCause cause) { session_.endMotion(id, cause); },
        .runsToEnd = {},
        .bounds =
            [this] {
                HoldBounds bounds;
                bounds.longestNs = HoldBounds::longestOf(moveSeconds(startMove_, session_.state()));
                bounds.holdTimeoutNs = HoldBounds::holdTimeoutAt(heldSpeed_().tcp, startMove_.speed);
                return bounds;
            },
    };
}

void RunBar::runOrStop() {
    if (runner_.isActive()) {
        runner_.stop(control::StopCause::StopButton);
    } else {
        run(script::StepGate::kUnlimited);
    }
}

void RunBar::run(std::int32_t permitted) {
    program::RunPlan planned = plan({});
    planned.obstacle = program::obstacleWithoutHold(planned.obstacle, planned.script.text, session_.state(),
                                                    preview_ ? &*preview_ : nullptr, previewed_.text);
    isHeld_ = false;
    if (planned.obstacle.isEmpty() && !isPreviewedInFull() && confirmedScript_ != planned.script.text) {
        askToRun(permitted, planned.script.text);
        return;
    }
    confirmedScript_.clear();
    hasChange_ = false;
    if (const auto begun = runner_.start(planned, control::Holding::Free, permitted); !begun) {
        Q_EMIT refused(reasonOf(begun.error()));
    }
}

void RunBar::askToRun(std::int32_t permitted, const QString& script) {
    const QString steps =
        program::stepNumbersText(program::stepsNotRun(document_.project(), previewed_, *preview_));
    ask(QStringLiteral("program.notSimulated"), tr("Run program"),
        tr("The preview did not run %1, so these steps were not checked for collisions and other problems. "
           "Test them with “Run (hold)”, or set the inputs and preview the program again.")
            .arg(steps),
        tr("Run"),
        // If the program was changed while the question was open, run() refuses it or asks again.
        [this, permitted, script] {
            confirmedScript_ = script;
            run(permitted);
        });
}

void RunBar::ask(const QString& name, const QString& title, const QString& text, const QString& accept,
                 const std::function<void()>& accepted) {
    auto* question = new QMessageBox(QMessageBox::Question, title, text, QMessageBox::NoButton, window());
    question->setObjectName(name);
    question->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* key = question->addButton(accept, QMessageBox::AcceptRole);
    key->setObjectName(name + QStringLiteral(".run"));
    QPushButton* keep = question->addButton(tr("Cancel"), QMessageBox::RejectRole);
    question->setDefaultButton(keep);
    question->setEscapeButton(keep);
    connect(key, &QPushButton::clicked, this, accepted);
    // The answer must not apply to another robot.
    connect(&session_, &RobotSession::linkBegan, question, &QWidget::close);
    question->open();
}

void RunBar::continueRun(const std::function<void()>& proceed) {
    if (!hasChange_ || isHeld_) {
        proceed();
        return;
    }
    ask(QStringLiteral("program.changed"), tr("Continue program"),
        tr("A variable was changed. The moves after this change were not previewed, so they were not checked "
           "for collisions and other problems."),
        tr("Continue"), [this, proceed] {
            hasChange_ = false;
            proceed();
        });
}

std::vector<program::InputChange> RunBar::inputs() const {
    std::vector<program::InputChange> inputs;
    const SessionState& state = session_.state();
    constexpr int kChannels = 18;
    for (int channel = 0; channel < kChannels && state.isFresh(); ++channel) {
        if (((state.digitalInputs >> channel) & 1U) != 0) {
            inputs.push_back({0, channel, true});
        }
    }
    return inputs;
}

void RunBar::pauseOrResume() {
    if (runner_.isPaused()) {
        continueRun([this] { runner_.resume(); });
    } else {
        runner_.pause();
    }
}

void RunBar::stepOnce() {
    if (runner_.isActive()) {
        continueRun([this] { runner_.step(); });
    } else {
        run(1);
    }
}

void RunBar::changeVariable(const QString& name, const QString& text) {
    if (const Result<void> changed = runner_.changeVariable(name, text); !changed) {
        Q_EMIT refused(changed.error().context);
    } else {
        hasChange_ = true;
    }
    updateGateKeys();
}

void RunBar::setSelectedStep(const QUuid& step) {
    selected_ = step;
    updateGateKeys();
}

void RunBar::setContinuation(const program::Continuation& continuation) {
    continuation_ = continuation;
    updateGateKeys();
}

bool RunBar::continues() const {
    return continuation_.start && continuation_.start->step == selected_;
}

RunBar::StoppedAt RunBar::stoppedAt() const {
    if (!runner_.isStoppedInLastStep()) {
        return {};
    }
    return {runner_.log().lastStep(),
            hasLostPower_ ? program::StopKind::PowerLoss : program::StopKind::Operator};
}

QString RunBar::keepPlace() {
    const bool mayNotContinue =
        !continuation_.text.isEmpty() && !continuation_.start && !continuation_.isUnknown;
    if (continuesStop_ && runner_.end() == program::ProgramRunner::End::Completed) {
        clearStartStep();
        Q_EMIT startStepChanged();
    }
    if (!isHeld_ || !runner_.isStoppedInLastStep() || mayNotContinue) {
        return {};
    }
    const program::StartStepChoice choice = program::chooseStoppedStep(
        document_.project(), program_, program::optionsFor(document_.project(), session_.state()),
        runner_.script(), runner_.log().lastStep(), session_.state().q);
    if (choice.start) {
        startStep_ = choice.start;
        continuesStop_ = true;
        updateAvailability();
        Q_EMIT startStepChanged();
    }
    return choice.obstacle.isEmpty() || !runner_.wasHeldTooLong() || isPreviewedInFull()
               ? choice.obstacle
               : tr("%1 Preview the program with the current inputs, or select a higher jog speed, so that "
                    "the program can run to the end.")
                     .arg(choice.obstacle);
}

void RunBar::clearStartStep() {
    if (startStep_) {
        stop(control::StopCause::SelectionChanged);
        startStep_.reset();
        continuesStop_ = false;
        updateAvailability();
    }
}

void RunBar::toggleStartStep() {
    if (startStep_) {
        clearStartStep();
        Q_EMIT startStepChanged();
        return;
    }
    const program::StartStepChoice choice =
        continues() ? program::StartStepChoice{continuation_.start, {}}
                    : program::chooseStartStep(document_.project(), program_, selected_,
                                               program::optionsFor(document_.project(), session_.state()),
                                               previewed_, preview_ ? &*preview_ : nullptr);
    startStep_ = choice.start;
    updateAvailability();
    if (startStep_) {
        stop(control::StopCause::SelectionChanged);
        Q_EMIT startStepChanged();
    } else {
        Q_EMIT refused(choice.obstacle);
    }
}

void RunBar::stop(control::StopCause cause) {
    hold_->guard().stop(cause);
    start_->guard().stop(cause);
}

void RunBar::follow(const SessionState& state) {
    hold_->setConfirmed(hold_->isHolding() && state.moving);
    start_->setConfirmed(start_->isHolding() && state.moving);
    if (!runner_.isActive() && state.robotMode == RobotMode::PowerOff &&
        !std::exchange(hasLostPower_, true)) {
        Q_EMIT stopChanged();
    }
    followOutputs(state);
    updateAvailability();
}

// The recoverability check assumes that the outputs have not changed since the stop.
void RunBar::followOutputs(const SessionState& state) {
    if (runner_.isActive() || runner_.state() == program::ProgramRunner::State::Idle || !state.hasData()) {
        return;
    }
    if (!stoppedOutputs_) {
        stoppedOutputs_ = state.digitalOutputs;
    }
    if (state.digitalOutputs == *stoppedOutputs_ || hasLostPower_ || std::exchange(hasOtherOutputs_, true)) {
        return;
    }
    const bool isChosen =
        startStep_ && continuation_.start && startStep_->step == continuation_.start->step && !continuesStop_;
    if (isChosen) {
        clearStartStep();
        Q_EMIT startStepChanged();
    }
    Q_EMIT stopChanged();
}

QString RunBar::programObstacle() const {
    if (script_.ok()) {
        return {};
    }
    return script_.problems.empty() ? tr("No program is selected. Create or select a program first.")
                                    : script_.problems.front().text;
}

QString RunBar::runObstacle() const {
    return program::obstacleWithoutHold(programObstacle(), script_.text, session_.state(),
                                        preview_ ? &*preview_ : nullptr, previewed_.text);
}

void RunBar::updateAvailability() {
    const QString robot = cannotMoveReason(session_.state());
    const QString programReason = programObstacle();
    using State = program::ProgramRunner::State;
    const bool isStarting =
        isHeld_ && (runner_.state() == State::Sending || runner_.state() == State::Running);
    // Do not disable a held button. The motion ends automatically, and a disabled button would not receive
    // the release.
    for (HoldToRunButton* key : {hold_, start_}) {
        if (!key->isHolding() && !(key == hold_ && isStarting)) {
            key->setUnavailable(programReason.isEmpty() ? robot : programReason);
        }
    }
    const bool stops = runner_.isActive() && (!isHeld_ || runner_.waitsForPress());
    const QString why = !robot.isEmpty() ? robot : runObstacle();
    run_->setEnabled(stops || why.isEmpty());
    setToolTipOf(*run_, stops ? tr("Stops the program")
                        : why.isEmpty()
                            ? tr("Runs the program at the programmed speed until it ends or is stopped. The "
                                 "arm also stops when Tiller closes or the connection is lost.")
                            : why);
    updateGateKeys();
}

bool RunBar::focusNextPrevChild(bool next) {
    const QWidget* focus = focusWidget();
    return (focus == nullptr || focus->isEnabled()) && QWidget::focusNextPrevChild(next);
}

void RunBar::updateGateKeys() {
    using State = program::ProgramRunner::State;
    const bool runs = runner_.state() == State::Sending || runner_.state() == State::Running;
    const bool isPaused = runs && runner_.isPaused();
    const QString idle = !runs ? tr("No program is running.")
                         : runner_.isPausedOnRobot()
                             ? tr("The program is paused on the robot. Resume it on the teach pendant.")
                             : QString();
    const QString pending = runner_.variables().pending();
    const QString changing =
        pending.isEmpty() ? QString() : tr("The value of “%1” is being changed.").arg(pending);
    const QString held = runner_.waitsForPress() ? tr("Hold “Continue (hold)” to continue.") : QString();
    pause_->setText(isPaused ? tr("Resume") : tr("Pause"));
    setReason(*pause_,
              !idle.isEmpty()   ? idle
              : !held.isEmpty() ? held
                                : changing,
              isPaused ? tr("Continues the program") : tr("Pauses the program before its next step"));
    setReason(*step_,
              runner_.isPausedOnRobot() ? idle
              : !held.isEmpty()         ? held
              : runner_.isActive()      ? !runner_.isWaiting() ? tr("Pause the program first.") : changing
              : run_->isEnabled()       ? QString()
                                        : run_->toolTip(),
              tr("Runs one step and then pauses the program"));
    setReason(*finish_,
              !idle.isEmpty()                   ? idle
              : runner_.script().cycles.empty() ? tr("The program has no endless loop.")
                                                : QString(),
              tr("Ends the program before the next cycle of its endless loop"));
    setReason(*from_,
              runner_.isActive()          ? cannotMoveReason(session_.state())
              : startStep_ || continues() ? QString()
              : !preview_                 ? runObstacle()
              : selected_.isNull()        ? tr("Select one step.")
                                          : QString(),
              startStep_ ? tr("The program starts at step %1. Press to start from the beginning instead.")
                               .arg(script_.numberOf(startStep_->step))
                         : tr("Starts the program at the selected step. Move the arm to the start position "
                              "first."));
    hold_->setText(continuesStop_ || runner_.waitsForPress() ? tr("Continue (hold)") : tr("Run (hold)"));
    from_->setChecked(startStep_.has_value());
    from_->setText(startStep_    ? tr("From step %1 ✕").arg(script_.numberOf(startStep_->step))
                   : continues() ? tr("Continue at %1").arg(continuation_.number)
                                 : tr("Start from here"));
    const QSignalBlocker blocker(finish_);
    finish_->setChecked(runs && runner_.endsWithCycle());
}

void RunBar::showRun() {
    hasLostPower_ = hasLostPower_ && !runner_.isActive();
    if (runner_.isActive()) {
        stoppedOutputs_.reset();
        hasOtherOutputs_ = false;
    }
    run_->setText(runner_.isActive() && (!isHeld_ || runner_.waitsForPress()) ? tr("Stop") : tr("Run"));
    updateAvailability();
    Q_EMIT runChanged();
}

void RunBar::showSpeed() {
    if (!hold_->isHolding()) {
        hold_->setDetail(program::numberText(limits().tool, program::Unit::Speed));
    }
}

}  // namespace tiller

#include "moc_run_bar.cpp"
