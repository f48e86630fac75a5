// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/program/run_bar.h"

#include <QHBoxLayout>
#include <algorithm>
#include <utility>

#include "robot/station/document/project_document.h"
#include "robot/station/link/obstacles.h"
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

/// Text of an error at the start of a motion: a sentence, or a text made of the code.
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
    , hold_(holdKey("program.runHold", tr("Run (hold)"), tr("Run the program, hold"),
                    tr("Runs the program from its beginning while the button is held, no faster than the jog "
                       "speed. The program ends when you release the button."),
                    policy))
    , start_(holdKey("program.moveToStart", tr("To start (hold)"), tr("Move to the start position, hold"),
                     tr("Moves all joints to the start position of the program while the button is held"),
                     policy))
    , run_(new EnterKey(tr("Run"))) {
    setObjectName("program.runBar");
    run_->setObjectName("program.run");
    run_->setAutoDefault(false);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(hold_, 1);
    layout->addWidget(start_, 1);
    layout->addWidget(run_);
    run_->setMinimumWidth(std::max(run_->sizeHint().width(), EnterKey(tr("Stop")).sizeHint().width()));
    hold_->setMotion(runner_.motion([this] {
        isHeld_ = true;
        return plan(limits());
    }));
    start_->setMotion(startMotion());
    for (HoldToRunButton* key : {hold_, start_}) {
        connect(&key->guard(), &HoldGuard::refused, this,
                [this](const Error& error) { Q_EMIT refused(reasonOf(error)); });
    }
    connect(run_, &QPushButton::clicked, this, &RunBar::runOrStop);
    connect(&runner_, &program::ProgramRunner::changed, this, &RunBar::showRun);
    connect(&session_, &RobotSession::stateChanged, this, &RunBar::follow);
    updateAvailability();
}

RunBar::~RunBar() {
    stop(control::StopCause::WindowClosed);
}

void RunBar::setProgram(const QUuid& program, const program::ProgramScript& script) {
    if (program != program_) {
        stop(control::StopCause::SelectionChanged);
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
    updateAvailability();
}

program::SpeedLimits RunBar::limits() const {
    const HeldSpeed held = heldSpeed_();
    // At this joint speed, the TCP of the extended arm reaches the TCP speed if one joint rotates.
    return {.tool = held.tcp, .joint = std::min(held.joint, held.tcp / session_.state().arm().reach)};
}

program::RunPlan RunBar::plan(const program::SpeedLimits& limits) const {
    program::RunPlan plan = program::planRun(document_.project(), program_, session_.state(), limits);
    if (preview_ && preview_->completed && previewed_.text == script_.text) {
        plan.expected = program::slowedDuration(*preview_, limits, session_.state().speedFraction);
    }
    return plan;
}

JointPositions RunBar::start() const {
    return preview_ && !preview_->path.empty() ? preview_->path.front().q
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
        return;
    }
    program::RunPlan planned = plan({});
    planned.obstacle = program::obstacleWithoutHold(planned, session_.state(),
                                                    preview_ ? &*preview_ : nullptr, previewed_.text);
    isHeld_ = false;
    if (const auto begun = runner_.start(planned, control::Holding::Free); !begun) {
        Q_EMIT refused(reasonOf(begun.error()));
    }
}

void RunBar::stop(control::StopCause cause) {
    hold_->guard().stop(cause);
    start_->guard().stop(cause);
}

void RunBar::follow(const SessionState& state) {
    hold_->setConfirmed(hold_->isHolding() && state.moving);
    start_->setConfirmed(start_->isHolding() && state.moving);
    updateAvailability();
}

QString RunBar::programObstacle() const {
    if (script_.ok()) {
        return {};
    }
    return script_.problems.empty() ? tr("There is no program to run.") : script_.problems.front().text;
}

QString RunBar::runObstacle() const {
    program::RunPlan known;
    known.script = script_;
    known.obstacle = programObstacle();
    return program::obstacleWithoutHold(known, session_.state(), preview_ ? &*preview_ : nullptr,
                                        previewed_.text);
}

void RunBar::updateAvailability() {
    const QString robot = cannotMoveReason(session_.state());
    const QString programReason = programObstacle();
    using State = program::ProgramRunner::State;
    const bool isStarting =
        isHeld_ && (runner_.state() == State::Sending || runner_.state() == State::Running);
    // A held button is not disabled: the motion ends by itself, and a disabled button would not receive the
    // release.
    for (HoldToRunButton* key : {hold_, start_}) {
        if (!key->isHolding() && !(key == hold_ && isStarting)) {
            key->setUnavailable(programReason.isEmpty() ? robot : programReason);
        }
    }
    const bool stops = runner_.isActive() && !isHeld_;
    const QString why = !robot.isEmpty() ? robot : runObstacle();
    run_->setEnabled(stops || why.isEmpty());
    run_->setToolTip(stops ? tr("Stops the program")
                     : why.isEmpty()
                         ? tr("Runs the program at its own speed until it ends or is stopped. The "
                              "arm also stops when Tiller closes or the connection is lost.")
                         : why);
}

void RunBar::showRun() {
    run_->setText(runner_.isActive() && !isHeld_ ? tr("Stop") : tr("Run"));
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
