// SPDX-License-Identifier: MIT
#include "robot/station/program/run/program_runner.h"

#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/receive/robot_state.h"
#include "robot/station/link/obstacles.h"
#include "robot/station/program/execution/start_conditions.h"
#include "robot/station/program/program_edit.h"
#include "robot/station/program/program_text.h"
#include "robot/station/program/recover/steps_not_reached.h"
#include "robot/station/program/step_kind.h"
#include "robot/station/text/error_summary.h"
#include "robot/station/text/texts.h"

namespace tiller::program {

namespace {

/// A hold-to-run program may take this multiple of the expected duration before the button must be pressed
/// again.
constexpr double kSlower = 1.5;

/// Upper bound of the TCP or elbow speed in a joint move in which the fastest joint rotates at 1 rad/s [m/s].
/// A joint moves the TCP at most by its distance from the axis, which is at most the length of all following
/// links.
double longestLever(const SessionState& state) {
    const DhParameters& dh = robotModel(state.model).dh;
    double sum = 0;
    double links = state.tcpOffset.position.norm();
    for (std::size_t joint = dh.a.size(); joint-- > 0;) {
        links += std::abs(dh.a[joint]);
        sum += links;
        links += std::abs(dh.d[joint]);  // parallel to the axis of this joint, so not part of its lever
    }
    return sum;
}

/// Like longestLever(), for the joint motions of this path.
double leverOf(const Preview& preview, const SessionState& state) {
    constexpr double kLeastTurn = 1e-4;  // [rad]
    constexpr double kChord = 1.05;      // samples are connected by chords, which are shorter than the path
    const DhParameters dh = state.arm().dh;
    double lever = 0;
    const auto elbow = [&dh](const PathSample& at) -> Eigen::Vector3d {
        return kinematics::linkFrames(dh, at.q)[2].translation();
    };
    for (std::size_t i = 1; i < preview.path.size(); ++i) {
        const PathSample& from = preview.path[i - 1];
        const PathSample& to = preview.path[i];
        const double turn = (to.q.values - from.q.values).cwiseAbs().maxCoeff();
        if (turn > kLeastTurn) {
            const double way =
                std::max((to.tcp.position - from.tcp.position).norm(), (elbow(to) - elbow(from)).norm());
            lever = std::max(lever, kChord * way / turn);
        }
    }
    return lever;
}

}  // namespace

ScriptOptions optionsFor(const project::Project& project, const SessionState& state,
                         const SpeedLimits& limits) {
    ScriptOptions options;
    options.limits = limits;
    if (state.version.major > 0) {
        options.version = state.version;
    }
    if (!project.robot && state.modelKnown) {
        options.model = state.model;
    }
    return options;
}

RunPlan planRun(const project::Project& project, const QUuid& program, const SessionState& state,
                const SpeedLimits& limits, const std::optional<StartStep>& start) {
    RunPlan plan;
    plan.project = project;
    plan.program = program;
    if (const project::Program* found = project.programs.find(program)) {
        plan.name = found->name;
    }
    plan.limits = limits;
    ScriptOptions options = optionsFor(project, state, limits);
    options.from = start ? start->step : QUuid();
    plan.script = writeScript(project, program, options);
    if (!plan.script.ok()) {
        const std::vector<ProgramProblem>& problems = plan.script.problems;
        plan.obstacle =
            problems.empty() ? ProgramText::tr("The program has no steps. Add steps first.")
            : problems.front().number > 0
                ? ProgramText::tr("Step %1: %2").arg(problems.front().number).arg(problems.front().text)
                : problems.front().text;
    } else if (!state.canMove()) {
        plan.obstacle = cannotMoveReason(state);
    } else if (project.robot && state.modelKnown && *project.robot != state.model) {
        plan.obstacle = ProgramText::tr(
                            "The project was taught with a %1, but the robot is a %2. Use “Adapt project to "
                            "this robot…” first.")
                            .arg(QLatin1String(robotModel(*project.robot).name),
                                 QLatin1String(robotModel(state.model).name));
    } else if (plan.script.tcp && !isSameTcp(*plan.script.tcp, state.tcpOffset)) {
        plan.obstacle = otherTcpText();
    } else if (start && !isAtStart(start->q, state.q)) {
        plan.obstacle = notAtStartText();
    }
    return plan;
}

bool isAtStart(const Preview& preview, const SessionState& state) {
    return !preview.path.empty() && isAtStart(preview.path.front().q, state.q);
}

SpeedLimits heldLimits(double tool, double joint, const SessionState& state, const Preview* preview) {
    const bool isKnown = preview != nullptr && preview->completed && isAtStart(*preview, state);
    const double lever = isKnown ? leverOf(*preview, state) : longestLever(state);
    return {.tool = tool, .joint = lever > 0 ? std::min(joint, tool / lever) : joint};
}

QString collisionText(const project::Project& project, const ProgramScript& script, const Preview& preview) {
    const auto collision =
        std::find_if(preview.findings.begin(), preview.findings.end(),
                     [](const Finding& each) { return each.kind == Finding::Kind::Collision; });
    return collision == preview.findings.end() ? QString() : findingText(project, script, *collision);
}

QString obstacleWithoutHold(const QString& obstacle, const QString& script, const SessionState& state,
                            const Preview* preview, const QString& previewed) {
    if (!obstacle.isEmpty()) {
        return obstacle;
    }
    if (preview == nullptr || previewed != script) {
        return ProgramText::tr("Preview the program first.");
    }
    if (!preview->isGood()) {
        return ProgramText::tr("The preview found problems. Fix them, then preview the program again.");
    }
    return isAtStart(*preview, state) ? QString() : notAtStartText();
}

double slowedDuration(const Preview& preview, const SpeedLimits& limits, double speedFraction) {
    double sum = 0;
    for (std::size_t i = 1; i < preview.path.size(); ++i) {
        const PathSample& from = preview.path[i - 1];
        const PathSample& to = preview.path[i];
        const double line = (to.tcp.position - from.tcp.position).norm() / limits.tool;
        const double joints = (to.q.values - from.q.values).cwiseAbs().maxCoeff() / limits.joint;
        // The script limits one of the two speeds, depending on the move type.
        sum += std::max({to.time - from.time, line, joints});
    }
    return sum / std::max(speedFraction, 0.01);
}

ProgramRunner::ProgramRunner(RobotSession& session, QObject* parent) : QObject(parent), session_(session) {
    connect(&session_, &RobotSession::samplesReceived, this, &ProgramRunner::take);
    connect(&session_, &RobotSession::stateChanged, this, &ProgramRunner::follow);
}

Result<RobotSession::MotionId> ProgramRunner::start(const RunPlan& plan, control::Holding holding,
                                                    std::int32_t permitted) {
    if (!plan.obstacle.isEmpty() || isActive()) {
        return Error{ErrorCode::Cancelled,
                     plan.obstacle.isEmpty()
                         ? ProgramText::tr("A program is running. Stop the program first.")
                         : plan.obstacle,
                     {}};
    }
    // Set the members before the session emits the new state.
    auto before = std::tuple(state_, id_, project_, program_, script_, log_, expected_, limits_, holding_,
                             endsByPause_, gate_, variables_);
    state_ = State::Sending;
    id_ = control::kNoMotion;
    project_ = plan.project;
    program_ = plan.program;
    script_ = plan.script;
    log_ = StepLog(static_cast<int>(script_.steps.size()));
    expected_ = plan.expected;
    limits_ = plan.limits;
    holding_ = holding;
    endsByPause_ = false;
    pausesHeld_ = waitsForPress_ = false;
    gate_ = RunGate(permitted);
    variables_.begin(script_);
    Q_EMIT variablesChanged();
    const QSet<QUuid> breakpoints = holding == control::Holding::Free ? breakpoints_ : QSet<QUuid>();
    const auto begun = session_.beginProgram(plan.name, script_.gatedText(breakpoints), holding,
                                             session_.stops(), gate_.value(), script_.variables);
    if (!begun) {
        std::tie(state_, id_, project_, program_, script_, log_, expected_, limits_, holding_, endsByPause_,
                 gate_, variables_) = std::move(before);
        Q_EMIT variablesChanged();
        return begun.error();
    }
    id_ = *begun;
    cause_ = control::StopCause::None;
    error_ = {};
    Q_EMIT changed();
    return id_;
}

HoldMotion ProgramRunner::motion(std::function<RunPlan()> plan) {
    return {
        .begin =
            [this, plan = std::move(plan)] {
                return waitsForPress() ? continueHeld() : start(plan(), control::Holding::Held);
            },
        .hold = [this](HoldMotion::Id id) { return hold(id); },
        .end = [this](HoldMotion::Id, control::StopCause cause) { stop(cause); },
        .runsToEnd = {},
        .bounds =
            [this] {
                HoldBounds bounds;
                // A program of unknown duration has the time limit of motions without a defined end.
                bounds.longestNs = expected_ > 0 ? HoldBounds::longestOf(kSlower * expected_) : 0;
                bounds.holdTimeoutNs = HoldBounds::holdTimeoutAt(limits_.tool, limits_.joint);
                return bounds;
            },
        .pause = [this] { return pauseHeld(); },
    };
}

bool ProgramRunner::hold(RobotSession::MotionId id) {
    if (pausesHeld_ && isWaiting()) {
        pausesHeld_ = false;
        waitsForPress_ = true;
        session_.hold(id);
        Q_EMIT changed();
        return false;
    }
    return session_.hold(id);
}

std::int64_t ProgramRunner::pauseHeld() {
    // A thread of the program could move the arm while the program waits.
    if (expected_ > 0 || script_.changesMayMove) {
        return 0;
    }
    pausesHeld_ = true;
    pause();
    const double seconds = moveSeconds();
    return seconds > 0 ? HoldBounds::longestOf(kSlower * seconds) : 0;
}

Result<RobotSession::MotionId> ProgramRunner::continueHeld() {
    if (const QString unconfirmed = variables_.unconfirmedText(); !unconfirmed.isEmpty()) {
        return Error{ErrorCode::Cancelled, unconfirmed, {}};
    }
    waitsForPress_ = false;
    RunGate gate = gate_;
    gate.resume(log_);
    setGate(gate);
    return id_;
}

/// Remaining duration of the running move to a waypoint [s]; 0: the step is not such a move.
double ProgramRunner::moveSeconds() const {
    if (log_.step() < 1 || !std::isfinite(limits_.joint) || limits_.joint <= 0) {
        return 0;
    }
    const project::ProgramStep* step =
        numberedStep(project_, script_.steps[static_cast<std::size_t>(log_.step() - 1)]);
    if (step == nullptr || (step->kind != QLatin1String("moveJ") && step->kind != QLatin1String("moveL"))) {
        return 0;
    }
    const QUuid id(step->fields.value(QLatin1String("waypoint")).toString());
    const auto target = std::find_if(project_.waypoints.begin(), project_.waypoints.end(),
                                     [&](const project::Waypoint& point) { return point.id == id; });
    if (target == project_.waypoints.end()) {
        return 0;
    }
    const SessionState& now = session_.state();
    const double turn = (target->joints.values - now.q.values).cwiseAbs().maxCoeff();
    constexpr double kMinFraction = 0.02;  // minimum of the speed slider
    return turn / limits_.joint / std::max(now.speedFraction, kMinFraction);
}

void ProgramRunner::stop(control::StopCause cause) {
    if (!isActive()) {
        return;
    }
    session_.endMotion(id_, cause);
    if (state_ != State::Stopping) {
        state_ = State::Stopping;
        Q_EMIT changed();
    }
}

void ProgramRunner::setGate(const RunGate& gate) {
    if (isActive() && gate != gate_) {
        gate_ = gate;
        session_.setStepGate(id_, gate_.value());
        Q_EMIT changed();
    }
}

void ProgramRunner::pause() {
    RunGate gate = gate_;
    gate.pause(log_);
    setGate(gate);
}

void ProgramRunner::resume() {
    if (!variables_.pending().isEmpty() || holding_ == control::Holding::Held) {
        return;
    }
    RunGate gate = gate_;
    gate.resume(log_);
    setGate(gate);
}

void ProgramRunner::setBreakpoints(const QSet<QUuid>& steps) {
    breakpoints_ = steps;
}

void ProgramRunner::passRemovedBreakpoint() {
    if (gate_.isAtBreakpoint(log_) && log_.step() > 0 &&
        !breakpoints_.contains(script_.steps[static_cast<std::size_t>(log_.step() - 1)].step)) {
        resume();
    }
}

void ProgramRunner::step() {
    if (isWaiting() && variables_.pending().isEmpty() && holding_ == control::Holding::Free) {
        RunGate gate = gate_;
        gate.step(log_);
        setGate(gate);
    }
}

void ProgramRunner::setEndsWithCycle(bool ends) {
    RunGate gate = gate_;
    gate.setEndsWithCycle(ends);
    setGate(gate);
}

RunPhase ProgramRunner::runPhase() const {
    return !isActive()         ? RunPhase::NoProgram
           : isPausedOnRobot() ? RunPhase::PausedOnRobot
           : isWaiting()       ? RunPhase::Waiting
                               : RunPhase::Running;
}

QString ProgramRunner::changeObstacle(const script::ProgramVariable& variable) const {
    return variables_.changeObstacle(variable, runPhase());
}

Result<void> ProgramRunner::changeVariable(const QString& name, const QString& text) {
    const Result<script::VariableChange> change = variables_.change(name, text, runPhase());
    if (!change) {
        return change.error();
    }
    RunGate gate = gate_;
    gate.change(*change);
    setGate(gate);
    return {};
}

void ProgramRunner::followVariables() {
    if (variables_.follow(session_.state().programVariables, session_.state().primaryStates)) {
        Q_EMIT variablesChanged();
    }
    if (const auto outcome = variables_.takeOutcome()) {
        RunGate gate = gate_;
        gate.withdrawChange();
        setGate(gate);
        Q_EMIT variableChanged(outcome->text, outcome->isConfirmed);
    }
}

void ProgramRunner::take(const SampleBatch& batch) {
    if (!isActive()) {
        return;
    }
    const auto shown = [this] {
        return std::tuple(log_.step(), log_.isWaiting(), log_.begun(), log_.isPausedOnRobot());
    };
    const auto before = shown();
    for (const receive::Sample& sample : batch.samples) {
        const receive::RobotState robot(sample);
        const int step = log_.step();
        log_.add(robot.timestamp(), robot.runtimeState(), robot.outputIntRegister(kStepRegister).value_or(0),
                 robot.outputIntRegister(script::kGateRegister).value_or(0));
        endsByPause_ = endsByPause_ || (holding_ == control::Holding::Held && log_.isPausedOnRobot());
        if (log_.step() > 0 && log_.step() != step) {
            Q_EMIT stepBegan(log_.step(),
                             log_.timings()[static_cast<std::size_t>(log_.step() - 1)].count == 1);
        }
    }
    if (log_.isPausedOnRobot() && !std::get<3>(before)) {
        session_.noteStopOnRobot();
    }
    const bool begins = state_ == State::Sending && log_.hasBegun();
    if (begins) {
        state_ = State::Running;
    }
    if (begins || shown() != before) {
        passRemovedBreakpoint();
        Q_EMIT changed();
    }
}

void ProgramRunner::follow() {
    const SessionState& now = session_.state();
    const bool isOther = now.hasForeignProgram() && now.control != ControlState::Taking;
    if (!isActive() && variables_.followOther(isOther ? now.programVariables : nullptr)) {
        Q_EMIT variablesChanged();
    }
    if (!isActive() || id_ == control::kNoMotion) {
        return;
    }
    if (waitsForPress()) {
        session_.hold(id_);  // the program only waits until the button is pressed again
    }
    followVariables();
    const Result<control::MotionProgress> progress = session_.motionProgress(id_);
    if (progress && progress->phase == control::MotionPhase::Active) {
        if (state_ == State::Running && log_.hasEnded()) {
            state_ = State::Stopping;
            Q_EMIT changed();
        }
        return;
    }
    finish(progress);
}

void ProgramRunner::finish(const Result<control::MotionProgress>& progress) {
    if (!progress && log_.lastStep() > 0 && !allowsMotion(session_.state().safety())) {
        // The safety system stopped the program, and control cannot be taken again yet.
        end_ = End::Stopped;
        cause_ = control::StopCause::UnsafeMode;
    } else if (!progress) {
        const SessionState& now = session_.state();
        const bool isTaken = progress.error().code == ErrorCode::NotInControl && log_.lastStep() > 0;
        end_ = isTaken && endsByPause_ ? End::PausedOnRobot
               : isTaken && now.controlLoss == control::ControlLoss::ScriptStopped && now.hasForeignProgram()
                   ? End::Replaced
                   : End::Failed;
        // Otherwise, the message would advise the operator to take control, which is not possible in Local
        // control.
        error_ = isTaken && now.remoteNeeded
                     ? Error{ErrorCode::RemoteControlRequired, progress.error().context, {}}
                     : progress.error();
    } else if (progress->cause != control::StopCause::Completed) {
        end_ = End::Stopped;
        cause_ = progress->cause;
    } else {
        end_ = log_.failedStep() > 0 ? End::StepFailed
               : log_.isCutShort()   ? End::StoppedOnRobot
               : !log_.hasEnded()    ? End::Unknown
                                     : End::Completed;
    }
    if (end_ == End::StoppedOnRobot || end_ == End::Replaced) {
        session_.noteStopOnRobot();
    }
    state_ = State::Ended;
    pausesHeld_ = waitsForPress_ = false;
    variables_.forgetChange();
    Q_EMIT changed();
}

bool ProgramRunner::isStoppedInLastStep() const {
    using control::StopCause;
    constexpr std::array kWithoutData{StopCause::DataStale, StopCause::LinkLost, StopCause::ControlLost,
                                      StopCause::EventLoopStalled, StopCause::Sleep};
    const bool isKnown = end_ == End::StoppedOnRobot || end_ == End::PausedOnRobot ||
                         (end_ == End::Stopped &&
                          std::find(kWithoutData.begin(), kWithoutData.end(), cause_) == kWithoutData.end());
    return state_ == State::Ended && isKnown && log_.lastStep() > 0;
}

QString ProgramRunner::endDetails() const {
    return end_ == End::Failed ? error_.toString() : QString();
}

bool ProgramRunner::wasHeldTooLong() const {
    return state_ == State::Ended && end_ == End::Stopped && cause_ == control::StopCause::HeldTooLong;
}

QString ProgramRunner::endText(const project::Project& now) const {
    const int number = end_ == End::StepFailed ? log_.failedStep() : log_.lastStep();
    const int step = rowNumber(now, script_, number);
    const QString name = stepName(project_, script_, number);
    QString reason;
    switch (end_) {
        case End::Completed:
            return ProgramText::tr("The program ended after %1 s.")
                .arg(QLocale().toString(log_.seconds(), 'f', 1));
        case End::StepFailed:
            return ProgramText::tr("Step %1 (%2) failed and ended the program.").arg(step).arg(name);
        case End::Stopped:
            reason = texts::stopCauseText(cause_);
            break;
        case End::StoppedOnRobot:
            reason = ProgramText::tr("ended on the robot (teach pendant, another client or halt)");
            break;
        case End::Unknown:
            reason = ProgramText::tr(
                "It is unknown whether the program completed, because robot data were missing at its end. "
                "Check the workpiece.");
            return step > 0 ? ProgramText::tr("Last known step: %1 (%2). %3").arg(step).arg(name, reason)
                            : reason;
        case End::PausedOnRobot:
            reason = ProgramText::tr("paused on the robot");
            break;
        case End::Replaced:
            reason = ProgramText::tr("a program from another client has taken over");
            break;
        case End::Failed:
            reason = texts::errorSummary(error_);
            break;
    }
    return step > 0 ? ProgramText::tr("Stopped in step %1 (%2): %3").arg(step).arg(name, reason)
                    : ProgramText::tr("Stopped before the first step: %1").arg(reason);
}

}  // namespace tiller::program

#include "moc_program_runner.cpp"
