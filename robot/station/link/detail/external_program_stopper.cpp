// SPDX-License-Identifier: MIT
#include "robot/station/link/detail/external_program_stopper.h"

#include <utility>

#include "robot/receive/robot_state.h"

namespace tiller {
namespace {

using control::StopCause;
using dashboard::RobotService;

constexpr std::int64_t kGiveUpNs = 3 * kNsPerSecond;
constexpr std::chrono::milliseconds kServiceTime{1500};

control::StopMeter::Sample measured(const receive::Sample& sample) {
    const receive::RobotState robot(sample);
    return {sample.hostTimeNs, robot.tcpPose().position, robot.tcpSpeed().linear.norm(),
            robot.qd().values.cwiseAbs().maxCoeff()};
}

script::ProgramStopperOptions stopperOptions(const QString& host, int portOffset, const Clock& clock) {
    script::ProgramStopperOptions options;
    options.host = host;
    options.port = script::kPrimaryPort + portOffset;
    options.clock = &clock;
    return options;
}

}  // namespace

ExternalProgramStopper::ExternalProgramStopper(QObject& context, const QString& host, int portOffset,
                                               const Clock& clock)
    : context_(context)
    , clock_(clock)
    , stopper_(stopperOptions(host, portOffset, clock))
    , service_(dashboard::serviceAt(host, portOffset))
    , freshService_(dashboard::serviceAt(host, portOffset)) {
    stopper_.start();
    service_.start();
    freshService_.start();
}

ExternalProgramStopper::~ExternalProgramStopper() {
    *wanted_ = false;
}

bool ExternalProgramStopper::isByStopKey(StopCause cause) {
    return cause == StopCause::StopButton || cause == StopCause::Escape || cause == StopCause::Space;
}

bool ExternalProgramStopper::isMeant(StopCause cause, const SessionState& state) {
    if (!isByStopKey(cause)) {
        return false;
    }
    const bool button = cause == StopCause::StopButton;
    if (state.control == ControlState::Taking) {
        return true;  // stops the program to be replaced, and the control script being uploaded
    }
    if (state.control == ControlState::InControl) {
        return false;
    }
    if (!state.isFresh()) {
        return button || state.controlInDoubt || state.sequence == 0 ||
               state.runtimeState != RuntimeState::Stopped;
    }
    return state.foreignProgramRuns() || state.moving ||
           (button && state.runtimeState == RuntimeState::Paused);
}

void ExternalProgramStopper::warmUp() {
    service_.post([](RobotService&, const Deadline&) { return Result<void>(); }, &context_,
                  [](const Result<void>&) {});
}

void ExternalProgramStopper::request(StopCause cause, const receive::Receiver& receiver) {
    stopper_.requestStop();
    *wanted_ = true;
    const receive::Sample newest = receiver.latest();
    request_ = StopRequest{clock_.nowNs(), newest.isEmpty() ? 0 : newest.sequence};
    askService();
    if (!newest.isEmpty() && !meter_.isMeasuring()) {
        measuredFrom_ = newest.sequence;
        meter_.add(measured(newest));
        if (meter_.isMoving()) {
            meter_.begin(cause, clock_.nowNs());
        }
    }
}

void ExternalProgramStopper::askService() {
    const auto stop = [wanted = wanted_](RobotService& service, const Deadline& deadline) -> Result<void> {
        // The job may have waited for a connection. It must not stop a program that was started in the
        // meantime.
        if (!*wanted) {
            return {};
        }
        const CancelToken withdrawn(
            [wanted, outer = deadline.token()] { return !*wanted || outer.isCancelled(); });
        return service.perform(dashboard::RobotCommand::StopProgram,
                               Deadline::after(deadline.remaining(), withdrawn));
    };
    service_.post(
        stop, &context_, [](const Result<void>&) {}, kServiceTime);
    if (answer_->busy) {
        return;
    }
    answer_->busy = true;
    answer_->error = {};
    freshService_.reconnect();
    freshService_.post(
        stop, &context_,
        [answer = answer_](const Result<void>& result) {
            answer->busy = false;
            answer->error = result.error();
        },
        kServiceTime);
}

void ExternalProgramStopper::withdraw() {
    *wanted_ = false;
    if (std::exchange(request_, std::nullopt)) {
        warmUp();  // cancelling a pending request closes its connection
    }
    stopper_.withdraw();
}

void ExternalProgramStopper::measure(const SampleBatch& batch) {
    for (const receive::Sample& sample : batch.samples) {
        if (isSafetyStop(sample) && !meter_.isMeasuring() && meter_.isMoving()) {
            measuredFrom_ = 0;
            meter_.begin(StopCause::UnsafeMode, sample.hostTimeNs);
        }
        if (!meter_.isMeasuring() || sample.sequence > measuredFrom_) {
            meter_.add(measured(sample));
        }
    }
}

/// True for the first sample of a stop by the safety system while a program of another client may be running.
bool ExternalProgramStopper::isSafetyStop(const receive::Sample& sample) {
    const bool allowed = allowsMotion(receive::RobotState(sample).safetyMode());
    return std::exchange(motionAllowed_, allowed) && !allowed && isExternal_;
}

bool ExternalProgramStopper::isStopped(const SessionState& state) const {
    if (state.isFresh()) {
        return state.sequence > request_->sequence && state.runtimeState == RuntimeState::Stopped;
    }
    return !stopper_.isUnderWay() && stopper_.error().code == ErrorCode::None;
}

std::optional<Error> ExternalProgramStopper::failure() const {
    const bool answered = !stopper_.isUnderWay() && !answer_->busy;
    const Error primary = stopper_.error();
    const bool bothRefuse =
        answered && primary.code != ErrorCode::None && answer_->error.code != ErrorCode::None;
    if (!bothRefuse && clock_.nowNs() - request_->ns < kGiveUpNs) {
        return std::nullopt;
    }
    const bool local = answer_->error.code == ErrorCode::RemoteControlRequired;
    return local || primary.code == ErrorCode::None ? answer_->error : primary;
}

ExternalProgramStopper::Outcome ExternalProgramStopper::follow(const SessionState& state,
                                                               const SampleBatch& batch) {
    measure(batch);
    isExternal_ = state.control == ControlState::None || state.control == ControlState::Refused;
    if (!request_) {
        return Outcome::None;
    }
    // While control is being taken, Tiller's own program may still start.
    if (state.control != ControlState::Taking && isStopped(state)) {
        withdraw();
        return Outcome::Stopped;
    }
    if (const auto failed = failure()) {
        error_ = *failed;
        withdraw();
        return Outcome::Failed;
    }
    return Outcome::None;
}

}  // namespace tiller
