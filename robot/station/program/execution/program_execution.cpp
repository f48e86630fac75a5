// SPDX-License-Identifier: MIT
#include "robot/station/program/execution/program_execution.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "robot/control/programs.h"
#include "robot/kinematics/arm_kinematics.h"
#include "robot/receive/robot_state.h"
#include "robot/rtde/fields.h"
#include "robot/script/script_client.h"
#include "robot/station/program/execution/start_conditions.h"
#include "robot/station/program/program_text.h"

namespace tiller::program {

using namespace std::chrono_literals;

namespace {

constexpr double kCheckedTime = 600;  // [s]
constexpr double kSamePlace = 0.02;   // [m]; a calibrated arm differs from its model by a few millimetres

/// True for findings that make a run on the robot unsafe. A missing input is not dangerous, because it can
/// only end a simulated run early.
bool isDangerous(const Finding& finding) {
    using Kind = Finding::Kind;
    return finding.kind == Kind::ScriptError || finding.kind == Kind::ProtectiveStop ||
           finding.kind == Kind::Collision;
}

/// Why the program does not fit the robot, as a sentence; empty if it does.
QString mismatch(const project::Project& project, const ProgramScript& script,
                 const receive::RobotState& robot) {
    const RobotModel& model = robotModel(project.robot.value_or(RobotModelId::UR5e));
    const Pose computed = kinematics::forwardTcp(model.dh, robot.q(), robot.tcpOffset());
    if (!((computed.position - robot.tcpPose().position).norm() < kSamePlace)) {
        return ProgramText::
            tr("The project was taught with a %1, but the robot is a different model. Adapt the project to "
               "the robot first.")
                .arg(QLatin1String(model.name));
    }
    return script.tcp && !isSameTcp(*script.tcp, robot.tcpOffset()) ? otherTcpText() : QString();
}

/// The error of a change of a variable that the robot has not confirmed.
Error unconfirmed(ErrorCode code) {
    return {code, QStringLiteral("change a variable"),
            QStringLiteral("the robot did not confirm the new value. Check the value of the variable")};
}

script::PrimaryClientOptions primaryOptions(const control::ControllerOptions& controller) {
    script::PrimaryClientOptions options;
    options.host = controller.host;
    options.port =
        controller.primaryPort != 0 ? controller.primaryPort : script::kPrimaryPort + controller.portOffset;
    options.clock = controller.clock;
    options.maxMessages = 1;  // the messages are not used
    return options;
}

}  // namespace

std::vector<std::string> executionFields() {
    return {"timestamp",
            "actual_q",
            "actual_TCP_pose",
            "tcp_offset",
            "runtime_state",
            rtde::intRegisterName(rtde::Direction::Output, kStepRegister),
            rtde::intRegisterName(rtde::Direction::Output, script::kGateRegister)};
}

CheckedProgram checkForRobot(const project::Project& project, const QUuid& program,
                             const ScriptOptions& options, const PreviewOptions& preview,
                             const receive::Sample& sample) {
    const receive::RobotState robot(sample);
    CheckedProgram checked{writeScript(project, program, options), robot.q(), {}};
    for (const ProgramProblem& problem : checked.script.problems) {
        checked.obstacles.append(problem.number > 0
                                     ? ProgramText::tr("Step %1: %2").arg(problem.number).arg(problem.text)
                                     : problem.text);
    }
    if (!checked.obstacles.isEmpty()) {
        return checked;
    }
    if (const QString why = mismatch(project, checked.script, robot); !why.isEmpty()) {
        checked.obstacles.append(why);
        return checked;
    }
    PreviewOptions limited = preview;
    limited.start = checked.start;
    limited.timeLimit = std::min(preview.timeLimit, kCheckedTime);
    for (const Finding& finding : previewProgram(project, checked.script, options, limited).findings) {
        if (isDangerous(finding)) {
            checked.obstacles.append(
                ProgramText::tr("Simulated: %1").arg(findingText(project, checked.script, finding)));
        }
    }
    return checked;
}

ProgramExecution::ProgramExecution(control::Controller& controller, receive::Subscription samples,
                                   CheckedProgram checked, const QSet<QUuid>& breakpoints,
                                   std::optional<std::uint64_t> stops)
    : controller_(controller)
    , samples_(std::move(samples))
    , script_(std::move(checked.script))
    , start_(checked.start)
    , log_(static_cast<int>(script_.steps.size()))
    , primary_(primaryOptions(controller.options())) {
    variables_.begin(script_);
    primary_.start();
    // Start the runner first, because its arguments copy the subscription from which the monitor then reads.
    runner_ = std::thread(&ProgramExecution::run, this, script_.gatedText(breakpoints),
                          stops.value_or(controller.stops()), samples_);
    monitor_ = std::thread(&ProgramExecution::monitor, this);
}

ProgramExecution::~ProgramExecution() {
    stop();
    token_.cancel();
    runner_.join();
    monitor_.join();
}

/// Requires that the arm is still at the checked position. Waits for a new sample.
Result<void> ProgramExecution::checkPosition(receive::Subscription& position) const {
    receive::Sample sample;
    while (position.next(sample)) {
    }
    if (const auto next = position.next(sample, Deadline::after(2s, token_)); !next) {
        return Error{
            ErrorCode::LinkLost,
            ProgramText::tr("The position of the arm is unknown because no robot data arrive. Check the "
                            "connection to the robot."),
            next.error().toString()};
    }
    return isAtStart(start_, receive::RobotState(sample).q())
               ? Result<void>()
               : Error{ErrorCode::Stopped, notAtStartText(), {}};
}

void ProgramExecution::run(const QString& text, std::uint64_t stops, receive::Subscription position) {
    Result<void> atStart;
    control::ScriptTerms terms;
    terms.stops = stops;
    terms.gate = script::StepGate();
    terms.variables = script_.variables;
    terms.starting = [&](const control::Motion& motion) {
        const Result<void> checked = checkPosition(position);  // called without the mutex, because
                                                               // checkPosition() waits
        const std::lock_guard lock(mutex_);
        if (isStopped_) {
            return false;
        }
        if (!checked) {
            atStart = checked;
            return false;
        }
        motion_ = motion;
        motion_.setGate(gate_.value());  // the gate may have changed since the start
        return true;
    };
    Result<void> outcome = control::Programs(controller_).runScript(text, Deadline::never(token_), terms);
    if (!atStart) {
        outcome = atStart;
    }
    const std::lock_guard lock(mutex_);
    outcome_ = outcome;
    changed_.notify_all();
}

void ProgramExecution::monitor() {
    constexpr auto kPoll = 50ms;
    receive::Sample sample;
    const auto add = [&] {
        const receive::RobotState robot(sample);
        const std::lock_guard lock(mutex_);
        log_.add(robot.timestamp(), robot.runtimeState(), robot.outputIntRegister(kStepRegister).value_or(0),
                 robot.outputIntRegister(script::kGateRegister).value_or(0));
    };
    for (bool isOver = false; !isOver;) {
        const Result<void> next = samples_.next(sample, Deadline::after(kPoll));
        if (next) {
            add();
        }
        followVariables();
        std::unique_lock lock(mutex_);
        const auto hasOutcome = [this] { return outcome_.has_value(); };
        // Without a receiver, next() returns at once.
        isOver = next || next.error().code == ErrorCode::Timeout ? hasOutcome()
                                                                 : changed_.wait_for(lock, kPoll, hasOutcome);
    }
    while (samples_.next(sample)) {
        add();
    }
    const std::lock_guard lock(mutex_);
    // A program that reaches its end resets the step register.
    if (*outcome_ && log_.isCutShort()) {
        outcome_ = Error{ErrorCode::Stopped, QStringLiteral("run the program"),
                         QStringLiteral("the program was ended on the robot")};
    } else if (*outcome_ && !log_.hasEnded() && log_.failedStep() == 0) {
        outcome_ = Error{
            ErrorCode::LinkLost, QStringLiteral("run the program"),
            QStringLiteral("it is unknown whether the program completed, because robot data were missing")};
    }
    isEnded_ = true;
    endChange(unconfirmed(ErrorCode::Stopped));
    changed_.notify_all();
}

void ProgramExecution::followVariables() {
    const script::PrimaryState state = primary_.isConnected() ? primary_.state() : script::PrimaryState();
    const std::lock_guard lock(mutex_);
    variables_.follow(state.variables, state.packages);
    if (const auto outcome = variables_.takeOutcome()) {
        endChange(outcome->isConfirmed ? Result<void>() : unconfirmed(ErrorCode::Timeout));
    }
}

/// Ends the call of changeVariable(), if there is one. Requires the mutex.
void ProgramExecution::endChange(const Result<void>& outcome) {
    if (!isChanging_ || hasChanged_) {
        return;
    }
    variables_.forgetChange();
    gate_.withdrawChange();
    sendGate();
    hasChanged_ = outcome;
    changed_.notify_all();
}

RunPhase ProgramExecution::runPhase() const {
    return isEnded_                                   ? RunPhase::NoProgram
           : log_.isPausedOnRobot()                   ? RunPhase::PausedOnRobot
           : gate_.isPaused(log_) && log_.isWaiting() ? RunPhase::Waiting
                                                      : RunPhase::Running;
}

std::vector<script::ProgramVariable> ProgramExecution::variables() const {
    const std::lock_guard lock(mutex_);
    return variables_.list();
}

Result<void> ProgramExecution::changeVariable(const QString& name, const QString& text,
                                              const Deadline& deadline) {
    std::unique_lock lock(mutex_);
    if (isChanging_) {
        return Error{
            ErrorCode::InvalidArgument,
            QStringLiteral("another variable is being changed. Wait until the robot has confirmed it"),
            {}};
    }
    const Result<script::VariableChange> change = variables_.change(name, text, runPhase());
    if (!change) {
        return change.error();
    }
    isChanging_ = true;
    hasChanged_.reset();
    gate_.change(*change);
    sendGate();
    while (!hasChanged_) {
        // Check the deadline without the mutex, because its token may call a function that waits for other
        // threads.
        lock.unlock();
        const bool hasExpired = deadline.hasExpired();
        const auto poll = hasExpired ? 0ms : deadline.nextPoll();
        lock.lock();
        if (!changed_.wait_for(lock, poll, [this] { return hasChanged_.has_value(); }) && hasExpired) {
            endChange(unconfirmed(deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout));
        }
    }
    isChanging_ = false;
    return *hasChanged_;
}

ProgramExecution::Status ProgramExecution::status() const {
    const std::lock_guard lock(mutex_);
    Status status;
    status.step = isEnded_ ? 0 : log_.step();
    status.lastStep = log_.lastStep();
    status.failedStep = log_.failedStep();
    status.isPaused = !isEnded_ && gate_.isPaused(log_);
    status.seconds = log_.seconds();
    status.timings = log_.timings();
    status.state = isEnded_                              ? !*outcome_              ? State::Stopped
                                                           : log_.failedStep() > 0 ? State::Failed
                                                                                   : State::Completed
                   : !log_.hasBegun()                    ? State::Starting
                   : status.isPaused && log_.isWaiting() ? State::Waiting
                                                         : State::Running;
    return status;
}

bool ProgramExecution::isActive() const {
    const std::lock_guard lock(mutex_);
    return !isEnded_;
}

void ProgramExecution::sendGate() {
    motion_.setGate(gate_.value());
}

void ProgramExecution::changeGate(void (RunGate::*change)(const StepLog&)) {
    const std::lock_guard lock(mutex_);
    (gate_.*change)(log_);
    sendGate();
    if (gate_.value().change.number == 0) {
        endChange(unconfirmed(ErrorCode::Stopped));
    }
}

void ProgramExecution::pause() {
    changeGate(&RunGate::pause);
}

void ProgramExecution::resume() {
    changeGate(&RunGate::resume);
}

void ProgramExecution::stepOnce() {
    changeGate(&RunGate::step);
}

void ProgramExecution::setEndsWithCycle(bool ends) {
    const std::lock_guard lock(mutex_);
    gate_.setEndsWithCycle(ends);
    sendGate();
}

void ProgramExecution::stop() {
    const std::lock_guard lock(mutex_);
    isStopped_ = true;
    endChange(unconfirmed(ErrorCode::Stopped));
    motion_.cancel(control::StopCause::ApiCall);
}

Result<void> ProgramExecution::wait(const Deadline& deadline) const {
    for (;;) {
        // Check the deadline without the mutex, because its token may call a function that waits for other
        // threads.
        const bool hasExpired = deadline.hasExpired();
        const auto poll = hasExpired ? 0ms : deadline.nextPoll();
        std::unique_lock lock(mutex_);
        if (changed_.wait_for(lock, poll, [this] { return isEnded_; })) {
            const int failed = log_.failedStep();
            return !*outcome_ || failed == 0
                       ? *outcome_
                       : Error{ErrorCode::ScriptError,
                               ProgramText::tr("Step %1 failed and ended the program.").arg(failed),
                               {}};
        }
        if (hasExpired) {
            lock.unlock();
            return Error{deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout,
                         QStringLiteral("wait for the end of the program"),
                         {}};
        }
    }
}

}  // namespace tiller::program
