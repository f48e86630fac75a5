// SPDX-License-Identifier: MIT
#include "robot/control/motion.h"

#include <algorithm>
#include <cmath>

#include "robot/control/detail/argument_check.h"
#include "robot/control/detail/controller_private.h"
#include "robot/control/jog.h"
#include "robot/core/wait_until.h"

namespace tiller::control {

namespace {

using std::chrono::milliseconds;

bool isLinear(MotionKind kind) {
    return kind == MotionKind::MoveL;
}

bool runsSection(MotionKind kind) {
    return kind == MotionKind::Path || kind == MotionKind::Function;
}

double distance(const std::array<double, 6>& a, const std::array<double, 6>& b, std::size_t count) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    }
    return std::sqrt(sum);
}

/// Error of a waiting caller if the motion did not reach its target.
/// delay  the delay that ended the motion; Kind::None: another cause
Error errorOf(StopCause cause, MotionKind kind, const MotionDelay& delay) {
    const QString context = QStringLiteral("wait for a motion");
    if (delay.kind != MotionDelay::Kind::None) {
        return {cause == StopCause::ControlLost ? ErrorCode::NotInControl : ErrorCode::LinkLost, context,
                delay.text()};
    }
    switch (cause) {
        case StopCause::UnsafeMode:
            return {ErrorCode::UnsafeState, context, QStringLiteral("the robot or safety mode changed")};
        case StopCause::Unreachable:
            return {ErrorCode::NoSolution, context, QStringLiteral("the arm cannot reach the target")};
        case StopCause::TargetTooFar:
            return {ErrorCode::LimitExceeded, context,
                    QStringLiteral("a target was too far from the previous target")};
        case StopCause::LinkLost:
            return {ErrorCode::LinkLost, context, QStringLiteral("the connection ended")};
        case StopCause::ControlLost:
            return {ErrorCode::NotInControl, context, QStringLiteral("the control program ended")};
        case StopCause::Superseded:
            return {ErrorCode::Stopped, context, QStringLiteral("another motion replaced this motion")};
        case StopCause::Contact:
            return {ErrorCode::Stopped, context, QStringLiteral("contact")};
        case StopCause::EventLoopStalled:
            return {ErrorCode::Stopped, context, QStringLiteral("the motion was not refreshed in time")};
        case StopCause::LimitReached:
            if (kind == MotionKind::Torque) {
                return {ErrorCode::LimitExceeded, context,
                        QStringLiteral(
                            "the TCP or the elbow exceeded the speed cap; change it with setSpeedCap()")};
            }
            return {ErrorCode::Stopped, context, QStringLiteral("a limit was reached")};
        default:
            return {ErrorCode::Stopped, context, QStringLiteral("the motion was stopped")};
    }
}

}  // namespace

MotionState Motion::state() const {
    if (controller_ == nullptr) {
        return {};
    }
    if (kind_ != MotionKind::Stop) {
        return controller_->motionState(id_);
    }
    // Late data alone do not end the wait, because the stop may still be confirmed.
    const ControllerStatus status = ControllerAccess::of(*controller_).loop.status();
    if (!status.inControl) {
        return {MotionPhase::Ended, StopCause::ControlLost};
    }
    const bool stands = status.restingEpoch >= id_ || status.epoch > id_;
    return {stands ? MotionPhase::Ended : MotionPhase::Active,
            stands ? StopCause::Completed : StopCause::None};
}

MotionProgress Motion::progress() const {
    MotionProgress progress;
    if (controller_ == nullptr) {
        return progress;
    }
    const MotionState now = state();
    const ControllerStatus status = controller_->status();
    progress.phase = now.phase;
    progress.cause = now.cause;
    progress.waypoints = waypoints_;
    progress.speedFraction = status.speedFraction;
    progress.speedScaling = status.speedScaling;
    const bool active = now.phase == MotionPhase::Active;
    progress.executing = active && status.motion == id_ && status.executing;
    if (now.cause == StopCause::Completed) {
        progress.fraction = 1;
        progress.waypoint = waypoints_;
    } else if (active && status.motion == id_) {
        if (waypoints_ > 0) {
            progress.waypoint = status.waypoint;
            progress.fraction = std::max(0.0, static_cast<double>(status.waypoint - 1) / waypoints_);
        } else if (kind_ == MotionKind::MoveJ || isLinear(kind_)) {
            const std::size_t count = isLinear(kind_) ? 3 : 6;
            const double whole = distance(from_, to_, count);
            const double left = distance(isLinear(kind_) ? status.tcpPose : status.q, to_, count);
            progress.fraction = whole > 0 ? std::clamp(1 - left / whole, 0.0, 1.0) : 0;
        }
    }
    return progress;
}

bool Motion::refresh() const {
    if (controller_ == nullptr || kind_ == MotionKind::Stop) {
        return false;
    }
    auto& d = ControllerAccess::of(*controller_);
    return d.mailbox.refresh(id_, d.now());
}

bool Motion::setGate(const script::StepGate& gate) const {
    return controller_ != nullptr && kind_ == MotionKind::Script &&
           ControllerAccess::of(*controller_).mailbox.setGate(id_, gate);
}

bool Jog::refresh(const JogTarget& target) const {
    Controller* const controller = MotionAccess::controller(*this);
    if (controller == nullptr) {
        return false;
    }
    if (!isFinite(target)) {
        cancel(StopCause::ApiCall);
        return false;
    }
    auto& d = ControllerAccess::of(*controller);
    return d.mailbox.refresh(id(), target, d.now());
}

Result<void> Motion::wait(const Deadline& deadline) const {
    MotionState now;
    const bool ended = waitUntil(deadline, [&] {
        now = state();
        return now.phase != MotionPhase::Active;
    });
    if (!ended) {
        return Error{deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout,
                     QStringLiteral("wait for a motion"), QStringLiteral("the motion is still running")};
    }
    if (now.cause == StopCause::Completed) {
        return {};
    }
    if (controller_ != nullptr && runsSection(kind_) && now.cause == StopCause::ControlLost) {
        // The controller's message arrives on another connection, possibly after the end of the motion.
        const Deadline soon =
            Deadline::after(std::min(milliseconds(500), deadline.remaining()), deadline.token());
        auto& d = ControllerAccess::of(*controller_);
        Error said;
        const auto heard = [&] {
            said = d.program.complaint(QStringLiteral("run a script"));
            return said.code != ErrorCode::None;
        };
        if (waitUntil(soon, heard)) {
            return said;
        }
    }
    MotionDelay delay;
    if (controller_ != nullptr) {
        delay = ControllerAccess::of(*controller_).loop.delay();
    }
    const bool delayed = delay.motion == id_ && delay.cause == now.cause;
    return errorOf(now.cause, kind_, delayed ? delay : MotionDelay());
}

Result<void> Motion::stop(const Deadline& deadline) const {
    if (controller_ == nullptr) {
        return {};
    }
    if (kind_ == MotionKind::Stop) {
        return wait(deadline);
    }
    cancel();
    const Controller::Private& d = ControllerAccess::of(*controller_);
    const Epoch& epoch = d.mailbox.epoch();
    ControllerStatus status;
    const auto isOver = [&] {
        // Read the epoch before the status: if the status confirms this epoch, the confirmation is current.
        const std::uint64_t now = epoch.current();
        const bool isReplaced = epoch.activeMotion() != kNoMotion;
        status = d.loop.status();  // late data alone do not end the wait: see state()
        return isReplaced || !status.inControl || status.restingEpoch >= now;
    };
    if (!waitUntil(deadline, isOver)) {
        return Error{deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout,
                     QStringLiteral("stop a motion"), QStringLiteral("the arm is still moving")};
    }
    const bool confirmed =
        status.inControl || status.loss == ControlLoss::Released || status.loss == ControlLoss::NotTaken;
    if (confirmed) {
        return {};
    }
    return Error{ErrorCode::NotInControl, QStringLiteral("stop a motion"),
                 QStringLiteral("control was lost; the robot brakes automatically")};
}

bool Motion::cancel(StopCause cause) const {
    return controller_ != nullptr && kind_ != MotionKind::Stop && controller_->end(id_, cause);
}

}  // namespace tiller::control
