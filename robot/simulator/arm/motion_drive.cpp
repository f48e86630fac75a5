// SPDX-License-Identifier: MIT
#include "robot/simulator/arm/motion_drive.h"

#include <algorithm>
#include <cmath>

#include "robot/simulator/arm/motion.h"
#include "robot/simulator/arm/torque_motion.h"

namespace tiller::simulator::arm {

namespace {
constexpr double kRampAcceleration = 12;       // rad/s2 of the fastest joint while program time is ramped
constexpr double kFastestRamp = 10;            // 1/s
constexpr double kEmergencyDeceleration = 25;  // rad/s2
constexpr double kAbandonedDeceleration = 4;   // rad/s2
constexpr double kTorqueEndDeceleration = 10;  // rad/s2
constexpr double kAccelerationTolerance = 1e-3;
}  // namespace

MotionDrive::MotionDrive(const ArmGeometry& geometry, double period, const JointPositions& start)
    : geometry_(geometry)
    , period_(period)
    , planner_(geometry, limits_)
    , path_(geometry, period)
    , velocity_(geometry, limits_, period) {
    limits_.speed = geometry.maxSpeed();
    state_.q = start.values;
}

void MotionDrive::setTcp(const Pose& T_flange_tcp) {
    tcpToCome_ = T_flange_tcp;
    if (mode_ != Mode::Path || !path_.followsTool()) {
        adoptTcp();
    }
}

void MotionDrive::adoptTcp() {
    if (!tcpToCome_) {
        return;
    }
    geometry_.setTcp(*tcpToCome_);
    tcpToCome_.reset();
    if (mode_ == Mode::Velocity) {
        velocity_.toolChanged(state_, velocityScale());
    }
}

MotionStart MotionDrive::begin() {
    MotionStart start;
    start.id = ++lastId_;
    records_[start.id % kRecords] = {start.id, MotionProgress::Running};
    abandonedFor_ = -1;
    return start;
}

MotionStart MotionDrive::ignored() {
    const MotionStart start = begin();
    finish(start.id, MotionProgress::Returned);
    return start;
}

void MotionDrive::finish(MotionId id, MotionProgress progress) {
    Record& record = records_[id % kRecords];
    if (id != 0 && record.id == id && record.progress == MotionProgress::Running) {
        record.progress = progress;
    }
}

void MotionDrive::supersede() {
    finish(activeId_, MotionProgress::Superseded);
    finish(goalId_, MotionProgress::Superseded);
    activeId_ = goalId_ = 0;
}

MotionProgress MotionDrive::progress(MotionId id) const {
    const Record& record = records_[id % kRecords];
    return record.id == id && id != 0 ? record.progress : MotionProgress::Superseded;
}

std::optional<MotionError> MotionDrive::refusal() const {
    if (!operational_ || protectiveStop_) {
        return MotionError::NotOperational;
    }
    return std::nullopt;
}

void MotionDrive::abandon() {
    if (mode_ != Mode::Rest && !(mode_ == Mode::Path && path_.current().kind == Segment::Kind::Stop)) {
        abandonedFor_ = 0;
    }
    supersede();
}

Pose MotionDrive::targetWaypoint() const {
    if (mode_ == Mode::Path && path_.goal().kind != Segment::Kind::Stop) {
        return Pose(path_.goal().endPoint.transform());
    }
    return Pose(geometry_.tcpPose(state_.q));
}

std::optional<MotionWarning> MotionDrive::takeWarning() {
    if (warningCount_ == 0) {
        return std::nullopt;
    }
    const MotionWarning first = warnings_[0];
    std::copy(warnings_.begin() + 1, warnings_.end(), warnings_.begin());
    --warningCount_;
    return first;
}

void MotionDrive::setOperational(bool operational) {
    if (operational_ && !operational) {
        // The brakes engage. Position control ends and the velocity is zero.
        supersede();
        path_.drop();
        velocity_.drop();
        mode_ = Mode::Rest;
        state_.qd.setZero();
    }
    operational_ = operational;
}

void MotionDrive::relocate(const JointTarget& state) {
    supersede();
    path_.drop();
    velocity_.drop();
    mode_ = Mode::Rest;
    state_ = state;
    if (moving()) {
        startStop(10, 0);
    }
}

void MotionDrive::rebase(const JointTarget& state) {
    if (mode_ == Mode::Rest) {
        state_.q = state.q;
    } else if (mode_ == Mode::Velocity) {
        state_.q = state.q;
        velocity_.relocated(state.q);
    }
}

void MotionDrive::abort(double deceleration) {
    supersede();
    const bool brakes =
        mode_ == Mode::Path && path_.current().kind == Segment::Kind::Stop && !path_.nextWaiting();
    // The end of the program must not accelerate a motion that a pause has slowed down.
    if (!brakes || (held_ && !path_.current().realTime)) {
        path_.drop();
        velocity_.drop();
        mode_ = Mode::Rest;
        startStop(deceleration, 0, readings_.programStopsScaled);
    }
    held_ = false;
}

void MotionDrive::raise(StopReason reason, int joint) {
    if (!protectiveStop_) {
        protectiveStop_ = ProtectiveStop{reason, joint, activeId_};
    }
    finish(activeId_, MotionProgress::Failed);
    finish(goalId_, MotionProgress::Failed);
    activeId_ = goalId_ = 0;
    path_.drop();
    velocity_.drop();
    mode_ = Mode::Rest;
    startStop(kEmergencyDeceleration, 0, readings_.programStopsScaled);
}

void MotionDrive::raiseFrom(const JointTarget& state, StopReason reason) {
    state_ = state;
    raise(reason, -1);
    stepStop();
}

// Plans a deceleration of all joints together from the current velocity in joint space.
bool MotionDrive::jointRunOut(double deceleration, Segment& segment, double pace) const {
    const Vector6 qd = state_.qd / pace;  // this and the following values are in the time base of the stop
    const double hardest = limits_.acceleration / (pace * pace);
    const double fastest = qd.cwiseAbs().maxCoeff();
    if (fastest <= 1e-9) {
        return false;
    }
    double duration = fastest / std::clamp(deceleration, 0.01, hardest);
    for (int j = 0; j < kJointCount; ++j) {
        const double v = std::abs(qd[j]);
        if (v > 1e-9) {
            const double left = limits_.position - (qd[j] > 0 ? state_.q[j] : -state_.q[j]);
            duration = std::min(duration, 2 * std::max(0.0, left) / v);
        }
    }
    duration = std::max(duration, fastest / hardest);
    segment = Segment{};
    segment.kind = Segment::Kind::Stop;
    segment.realTime = pace >= 1;
    segment.from = segment.q = state_.q;
    segment.direction = qd / fastest;
    segment.profile = SpeedProfile::stop(fastest, duration);
    segment.endQ = state_.q + qd * (0.5 * duration);
    return true;
}

double MotionDrive::stopPace(bool scaled) const {
    constexpr double kStandingTime = 1e-3;  // below this rate, program time is considered stopped
    // A pause freezes program time. Because a stop must end even then, it runs in real time, like a stop that
    // is not scaled.
    return !scaled || held_ || programScale_ < kStandingTime ? 1 : programScale_;
}

void MotionDrive::startStop(double deceleration, MotionId id, bool scaled) {
    path_.drop();
    velocity_.drop();
    pathScale_ = programScale_;
    if (!jointRunOut(deceleration, runOut_, stopPace(scaled))) {
        state_.qd.setZero();
        mode_ = Mode::Rest;
        finish(id, MotionProgress::Returned);
        return;
    }
    runOut_.id = activeId_ = id;
    path_.start(runOut_);
    mode_ = Mode::Path;
}

void MotionDrive::startVelocity(MotionId id, std::optional<double> t) {
    supersede();
    path_.drop();
    // With scaled program time, t is not a multiple of the period. The overruns of successive commands must
    // not accumulate.
    const bool follows = mode_ == Mode::Velocity && !blocking_ && sinceReturned_ == 0;
    const double spent = follows && t ? overrun_ : 0.0;
    overrun_ = 0;
    if (mode_ != Mode::Velocity) {
        velocityPace_ = velocityScale();
    }
    mode_ = Mode::Velocity;
    activeId_ = id;
    blocking_ = true;
    blocksUntilSpeed_ = !t.has_value();
    blockingLeft_ = t.value_or(0) - spent;
    sinceReturned_ = 0;
}

void MotionDrive::step() {
    stepScale();
    if (abandonedFor_ >= 0) {
        abandonedFor_ += period_;
        if (abandonedFor_ > Motion::kSpeedHold) {
            abandonedFor_ = -1;
            startStop(kAbandonedDeceleration, 0);
        }
    }
    if (mode_ == Mode::Rest) {
        adoptTcp();
    }
    switch (mode_) {
        case Mode::Rest:
            state_.qd.setZero();
            scaling_ = held_ ? 0 : 1;
            explainScaling(1, false);
            break;
        case Mode::Path:
            stepPath();
            break;
        case Mode::Velocity:
            stepVelocity();
            break;
        case Mode::Torque:
            stepTorque();
            break;
    }
}

// Ramps the rate of program time within the joint limits, or changes it at once if the arm is at rest.
void MotionDrive::stepScale() {
    const double wanted = held_ ? 0 : slider_;
    const double going = held_ ? 0 : 1;
    if (mode_ == Mode::Rest) {
        programScale_ = pathScale_ = wanted;
        pauseScale_ = going;
        programRate_ = 0;
        return;
    }
    const double rate = std::min(kFastestRamp, kRampAcceleration / std::max(programRate_, 1e-3));
    programScale_ = std::clamp(wanted, programScale_ - rate * period_, programScale_ + rate * period_);
    pauseScale_ = std::clamp(going, pauseScale_ - rate * period_, pauseScale_ + rate * period_);
}

// Returns the factor 0..1 by which qd must be scaled to keep the tool speed limit.
double MotionDrive::toolSpeedFactor(const Vector6& qd) const {
    if (!std::isfinite(toolSpeedLimit_)) {
        return 1;
    }
    Posture posture;
    geometry_.evaluate(state_.q, posture);
    const double speed = (posture.jacobian * qd).head<3>().norm();
    return speed > toolSpeedLimit_ ? toolSpeedLimit_ / speed : 1.0;
}

// Reports the limit that slowed this step. Pause and resume are not limits.
void MotionDrive::explainScaling(double toolFactor, bool byJoints) {
    scaledBy_ = byJoints              ? TimeScaleSource::JointSpeed
                : toolFactor < 1      ? TimeScaleSource::ToolSpeed
                : scaling_ < 1 - 1e-6 ? TimeScaleSource::Other
                                      : TimeScaleSource::NotScaled;
}

// Determines the rate of program time for this step that keeps every joint within its speed and acceleration
// limits.
std::optional<StopReason> MotionDrive::chooseStep(double target, double& scale, PathCandidate& candidate,
                                                  int& joint) {
    const double possible = limits_.acceleration * period_;
    double next = target;
    for (int attempt = 0; attempt < 4; ++attempt) {
        const double dtProgram = 0.5 * (pathScale_ + next) * period_;
        path_.evaluate(period_, dtProgram, candidate);
        if (!candidate.reached) {
            return StopReason::Singularity;
        }
        double low = 0;
        double high = target;
        for (int j = 0; j < kJointCount; ++j) {
            const double rate = candidate.rateProgram[j];
            const double rest = candidate.rateReal[j];
            if (std::abs(rate) < 1e-12) {
                continue;
            }
            const double top = std::min(state_.qd[j] + possible, limits_.speed[j]) - rest;
            const double bottom = std::max(state_.qd[j] - possible, -limits_.speed[j]) - rest;
            low = std::max(low, (rate > 0 ? bottom : top) / rate);
            high = std::min(high, (rate > 0 ? top : bottom) / rate);
        }
        const double better = std::clamp(next, std::min(low, high), std::max(low, high));
        if (std::abs(better - next) < 1e-6) {
            break;
        }
        next = better;
    }
    scale = next;
    const Vector6 qd = candidate.rateProgram * scale + candidate.rateReal;
    const double slack = 1 + kAccelerationTolerance;
    // All joints stop together, so the fastest joint determines the duration.
    const double stopTime = period_ + qd.cwiseAbs().maxCoeff() / (2 * limits_.acceleration);
    if (!limits_.continuous(state_, {candidate.q, qd}, period_)) {
        return StopReason::Singularity;
    }
    for (int j = 0; j < kJointCount; ++j) {
        if (std::abs(qd[j] - state_.qd[j]) > possible * slack + 1e-9 ||
            std::abs(qd[j]) > limits_.speed[j] * slack + 1e-9) {
            joint = j;
            return StopReason::JointSpeedLimit;
        }
        // Every joint must be able to stop within its range. A move between two joint positions meets this
        // condition, because both positions are within the range.
        const double outward = candidate.q[j] > 0 ? qd[j] : -qd[j];
        const double stopping = outward > 0 ? outward * stopTime : 0.0;
        if (!path_.withinItsEnds() && std::abs(candidate.q[j]) + stopping > limits_.position) {
            joint = j;
            return StopReason::JointPositionLimit;
        }
    }
    return std::nullopt;
}

void MotionDrive::pathFailed(StopReason reason, int joint) {
    if (path_.current().kind == Segment::Kind::Stop) {
        // If the stop along the tool direction cannot be followed, stop in joint space.
        const MotionId id = activeId_;
        startStop(kEmergencyDeceleration, id);
        return;
    }
    raise(reason, joint);
}

// Executes the first step of a joint-space stop that has begun within this period.
void MotionDrive::stepStop() {
    if (mode_ != Mode::Path) {
        return;
    }
    const double dtProgram = programScale_ * period_;
    path_.evaluate(period_, dtProgram, candidate_);
    path_.commit(period_, dtProgram, candidate_);
    state_.q = candidate_.q;
    state_.qd = candidate_.rateProgram * programScale_ + candidate_.rateReal;
}

void MotionDrive::stepPath() {
    const bool realTime = path_.current().realTime;
    path_.prepare(programScale_ * period_);
    double scale = pathScale_;
    const double toolFactor = toolSpeedFactor(candidate_.rateProgram * programScale_);
    const double target = std::min(programScale_ * toolFactor, pathScale_ + 0.5 * kFastestRamp * period_);
    int limited = -1;
    if (const auto failure = chooseStep(target, scale, candidate_, limited)) {
        pathFailed(*failure, limited);
        stepStop();
        return;
    }
    const double dtProgram = 0.5 * (pathScale_ + scale) * period_;
    path_.commit(period_, dtProgram, candidate_);
    state_.q = candidate_.q;
    state_.qd = candidate_.rateProgram * scale + candidate_.rateReal;
    pathScale_ = scale;
    programRate_ = candidate_.rateProgram.cwiseAbs().maxCoeff();
    scaling_ = realTime ? 1 : std::clamp(scale / std::max(slider_, 1e-3), 0.0, 1.0);
    explainScaling(toolFactor, !realTime && scale < target - 1e-6);

    if (goalId_ != 0 && !path_.nextWaiting()) {
        activeId_ = goalId_;
        goalId_ = 0;
    }
    if (path_.currentReturned(std::max(programScale_, pathScale_))) {
        finish(activeId_, MotionProgress::Returned);
    }
    if (path_.finished() || (realTime && path_.current().finished())) {
        const std::optional<StopReason> fault = path_.current().endFault;
        const int joint = path_.current().endFaultJoint;
        state_.qd.setZero();
        path_.drop();
        mode_ = Mode::Rest;
        if (fault) {
            raise(*fault, joint);
            return;
        }
        finish(activeId_, MotionProgress::Returned);
        activeId_ = 0;
    }
}

void MotionDrive::stepVelocity() {
    if (!blocking_ && sinceReturned_ > Motion::kSpeedHold) {
        velocity_.expire();
    }
    int joint = -1;
    const JointTarget before = state_;
    const Vector6 rates = state_.qd / std::max(velocityPace_, 1e-2);
    const double toolFactor = toolSpeedFactor(rates * velocityScale());
    velocityPace_ = velocityScale() * toolFactor;
    const std::optional<StopReason> stop = velocity_.step(velocityPace_, state_, joint);
    scaling_ =
        velocity_.slowedBy() *
        std::clamp(velocityPace_ / std::max(readings_.speedCommandsScaled ? slider_ : 1.0, 1e-3), 0.0, 1.0);
    explainScaling(toolFactor, velocity_.slowedBy() < 1);
    programRate_ = state_.qd.cwiseAbs().maxCoeff() / std::max(velocityScale(), 1e-2);
    if (stop) {
        state_ = before;
        raise(*stop, joint);
        stepStop();
        return;
    }
    if (blocking_) {
        blockingLeft_ -= period_ * velocityScale();
        const bool servoC = velocity_.kind() == VelocityMotion::Kind::ServoC;
        const bool over = servoC              ? velocity_.targetReached()
                          : blocksUntilSpeed_ ? velocity_.speedReached()
                                              : blockingLeft_ <= 1e-9;
        if (over) {
            blocking_ = false;
            sinceReturned_ = 0;
            overrun_ = servoC || blocksUntilSpeed_
                           ? 0.0
                           : std::clamp(-blockingLeft_, 0.0, period_ * velocityScale());
            finish(activeId_, MotionProgress::Returned);
        }
        return;
    }
    sinceReturned_ += period_;
    if (sinceReturned_ > Motion::kSpeedHold && !held_ && velocity_.settled(state_)) {
        velocity_.drop();
        state_.qd.setZero();
        mode_ = Mode::Rest;
        activeId_ = 0;
    }
}

void MotionDrive::stepTorque() {
    if (!blocking_) {
        // The command was not repeated within a period. Return to position control.
        startStop(kTorqueEndDeceleration, 0);
        stepStop();
        return;
    }
    const JointTarget before = state_;
    int joint = -1;
    if (const auto stop = torque_->step(period_, limits_, state_, joint)) {
        state_ = before;
        raise(*stop, joint);
        stepStop();
        return;
    }
    blocking_ = false;
    finish(activeId_, MotionProgress::Returned);
}

}  // namespace tiller::simulator::arm
