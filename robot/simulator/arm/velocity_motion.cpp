// SPDX-License-Identifier: MIT
#include "robot/simulator/arm/velocity_motion.h"

#include <algorithm>
#include <cmath>

namespace tiller::simulator::arm {

namespace {
constexpr double kNoScale = 1e-3;     // below this rate, program time is considered stopped
constexpr double kSingular = 0.06;    // singularity margin at which Cartesian motion ends
constexpr double kCreeping = 1e-3;    // limit for standstill: rad/s, or fraction of the requested speed
constexpr double kExpiryJoint = 2.0;  // rad/s2, minimum deceleration when a speed command expires
constexpr double kExpiryTool = 0.5;   // m/s2
}  // namespace

void VelocityMotion::begin(Kind kind, const JointTarget& now, double timeScale) {
    if (running_ && kind == kind_) {
        return;
    }
    const bool wasCartesian = running_ && (kind_ == Kind::SpeedL || kind_ == Kind::ServoC);
    const bool isCartesian = kind == Kind::SpeedL || kind == Kind::ServoC;
    const Vector6 rates = now.qd / std::max(timeScale, kNoScale);
    if (isCartesian && !wasCartesian) {
        geometry_.evaluate(now.q, posture_);
        tool_ = ToolPoint(posture_.T_base_tcp);
        velocity_ = posture_.jacobian * rates;
    } else if (!isCartesian) {
        velocity_ = rates;
    }
    targetVelocity_.setZero();
    servoRate_.setZero();
    servoFiltered_ = isCartesian ? Vector6::Zero() : velocity_;
    servoPeriod_ = 0;
    kind_ = kind;
    running_ = true;
}

void VelocityMotion::toolChanged(const JointTarget& now, double timeScale) {
    if (running_ && (kind_ == Kind::SpeedL || kind_ == Kind::ServoC)) {
        geometry_.evaluate(now.q, posture_);
        tool_ = ToolPoint(posture_.T_base_tcp);
        velocity_ = posture_.jacobian * now.qd / std::max(timeScale, kNoScale);
    }
}

void VelocityMotion::speedJ(const JointTarget& now, double timeScale, const Vector6& qd, double a) {
    begin(Kind::SpeedJ, now, timeScale);
    targetVelocity_ = qd;
    // Limit the target velocity, because the arm would never reach speeds beyond the joint limits.
    const double factor = limits_.speedFactor(qd);
    targetVelocity_ *= factor;
    a_ = a;
    speedReached_ = false;
}

void VelocityMotion::speedL(const JointTarget& now, double timeScale, const Vector6& twist, double a,
                            double aRot) {
    begin(Kind::SpeedL, now, timeScale);
    targetVelocity_ = twist;
    a_ = a;
    aRot_ = aRot;
    speedReached_ = false;
}

void VelocityMotion::servoJ(const JointTarget& now, double timeScale, const Vector6& q, double t,
                            double lookahead, double gain) {
    const bool goesOn = running_ && kind_ == Kind::ServoJ && servoPeriod_ > 0;
    begin(Kind::ServoJ, now, timeScale);
    servoRate_ = goesOn ? Vector6((q - servoQ_) / servoPeriod_) : Vector6::Zero();
    servoRate_ = servoRate_.cwiseMin(limits_.speed).cwiseMax(-limits_.speed);
    servoQ_ = q;
    servoPeriod_ = std::max(t, period_ * std::max(timeScale, kNoScale));
    lookahead_ = lookahead;
    gain_ = gain;
}

void VelocityMotion::servoC(const JointTarget& now, double timeScale, const ToolPoint& target, double a,
                            double v, double r) {
    begin(Kind::ServoC, now, timeScale);
    servoCTarget_ = target;
    a_ = a;
    aRot_ = a / kEquivalentRadius;
    servoCSpeed_ = v;
    servoCRadius_ = r;
    targetReached_ = false;
}

void VelocityMotion::expire() {
    if (kind_ == Kind::SpeedJ || kind_ == Kind::SpeedL) {
        targetVelocity_.setZero();
        const double least = kind_ == Kind::SpeedJ ? kExpiryJoint : kExpiryTool;
        a_ = std::max(a_, least);
        aRot_ = std::max(aRot_, kExpiryJoint);
    }
    servoRate_.setZero();
    servoPeriod_ = 0;
}

std::optional<StopReason> VelocityMotion::step(double timeScale, JointTarget& state, int& joint) {
    slowedBy_ = 1;
    joint = -1;
    std::optional<StopReason> stop;
    switch (kind_) {
        case Kind::SpeedJ:
            stop = stepSpeedJ(timeScale, state, joint);
            break;
        case Kind::ServoJ:
            stop = stepServoJ(timeScale, state, joint);
            break;
        case Kind::ServoC:
            pursue();
            [[fallthrough]];
        case Kind::SpeedL:
            stop = stepCartesian(timeScale, state, joint);
            break;
    }
    return stop;
}

bool VelocityMotion::settled(const JointTarget& state) const {
    if (state.qd.cwiseAbs().maxCoeff() > 1e-4) {
        return false;
    }
    if (kind_ == Kind::ServoJ) {
        return (servoQ_ - state.q).cwiseAbs().maxCoeff() < 1e-5;
    }
    return kind_ == Kind::ServoC || targetVelocity_.isZero(1e-9);
}

std::optional<StopReason> VelocityMotion::stepSpeedJ(double timeScale, JointTarget& state, int& joint) {
    const Vector6 change = targetVelocity_ - velocity_;
    const double most = change.cwiseAbs().maxCoeff();
    const double possible = a_ * period_ * timeScale;
    velocity_ = most <= possible ? targetVelocity_ : Vector6(velocity_ + change * (possible / most));
    Vector6 wanted = velocity_ * timeScale;
    double factor = limits_.speedFactor(wanted);
    factor *= limits_.rangeFactor(state.q, wanted * factor, period_, joint);
    wanted *= factor;
    velocity_ *= factor;
    slowedBy_ = factor;
    if (limits_.cutToAcceleration(state.qd, wanted, period_) && timeScale > kNoScale) {
        velocity_ = wanted / timeScale;
    }
    speedReached_ = most <= possible || factor < 1;
    state.q += 0.5 * (state.qd + wanted) * period_;
    state.qd = wanted;
    const bool stands = state.qd.cwiseAbs().maxCoeff() < kCreeping;
    if (factor < 0.5 && joint >= 0 && stands && targetVelocity_.cwiseAbs().maxCoeff() > kCreeping) {
        return StopReason::JointPositionLimit;
    }
    return std::nullopt;
}

// servoC: straight to the target, as fast as the remaining distance permits.
void VelocityMotion::pursue() {
    const Eigen::Vector3d way = servoCTarget_.p - tool_.p;
    const Eigen::Vector3d turn = vectorFromQuaternion(servoCTarget_.R * tool_.R.conjugate());
    const double distance = way.norm();
    const double angle = turn.norm();
    const double length = std::max(distance, kEquivalentRadius * angle);
    targetReached_ = distance <= std::max(servoCRadius_, 1e-4) && (angle < 1e-3 || servoCRadius_ > 0);
    if (length < 1e-9) {
        targetVelocity_.setZero();
        return;
    }
    // The last term prevents overshoot in the final steps.
    const double speed = std::min({servoCSpeed_, std::sqrt(a_ * length), 0.1 * length / period_});
    targetVelocity_ << way * (speed / length), turn * (speed / length);
}

std::optional<StopReason> VelocityMotion::stepCartesian(double timeScale, JointTarget& state, int& joint) {
    const Vector6 change = targetVelocity_ - velocity_;
    const double possible = a_ * period_ * timeScale;
    const double possibleRot = aRot_ * period_ * timeScale;
    const double most = change.head<3>().norm();
    const double mostRot = change.tail<3>().norm();
    const Vector6 before = velocity_;
    velocity_.head<3>() += change.head<3>() * (most <= possible ? 1.0 : possible / most);
    velocity_.tail<3>() += change.tail<3>() * (mostRot <= possibleRot ? 1.0 : possibleRot / mostRot);
    speedReached_ = most <= possible && mostRot <= possibleRot;

    const auto advanced = [&](double factor) {
        const Vector6 mean = 0.5 * (before + velocity_) * (timeScale * factor * period_);
        return ToolPoint(tool_.p + mean.head<3>(), quaternionFromVector(mean.tail<3>()) * tool_.R);
    };
    ToolPoint tool = advanced(1);
    Vector6 q = state.q;
    Vector6 qd = Vector6::Zero();
    bool reached = geometry_.follow(tool.transform(), q, posture_);
    const double marginAfter = reached ? geometry_.singularityMargin(q, posture_) : 0.0;
    reached = reached && geometry_.jointRates(posture_, velocity_ * timeScale, qd);
    if (!reached) {
        return StopReason::Singularity;
    }
    Posture& posture = posture_;
    geometry_.evaluate(state.q, posture);
    const double margin = geometry_.singularityMargin(state.q, posture);

    double factor = limits_.speedFactor(qd);
    if (marginAfter < margin && marginAfter < 1) {
        // Near a singular position, the speed towards it is reduced in proportion to the remaining distance.
        const double usable = std::max(0.0, (marginAfter - kSingular) / (1 - kSingular));
        const double worst = (qd.cwiseAbs().array() / limits_.speed.array()).maxCoeff();
        const double approach = (margin - marginAfter) / period_;
        factor = std::min(factor, usable / std::max(worst, 1e-9));
        factor = std::min(factor, 4 * std::max(0.0, marginAfter - kSingular) / std::max(approach, 1e-9));
    }
    const double singularFactor = factor;
    factor *= limits_.rangeFactor(state.q, qd * factor, period_, joint);
    const bool rangeLimited = factor < singularFactor;
    if (!rangeLimited) {
        joint = -1;
    }
    if (factor < 1) {
        slowedBy_ = factor;
        speedReached_ = true;
        velocity_ *= factor;
        tool = advanced(1);
        q = state.q;
        if (!geometry_.follow(tool.transform(), q, posture) ||
            !geometry_.jointRates(posture, velocity_ * timeScale, qd)) {
            return StopReason::Singularity;
        }
    }
    const double excess = limits_.speedFactor(qd);
    qd *= excess;
    if (limits_.cutToAcceleration(state.qd, qd, period_) || excess < 1) {
        // The arm has left the requested path in this step. Continue from the actual joint positions.
        state.q += 0.5 * (state.qd + qd) * period_;
        geometry_.evaluate(state.q, posture);
        tool = ToolPoint(posture.T_base_tcp);
        if (timeScale > kNoScale) {
            velocity_ = posture.jacobian * qd / timeScale;
        }
    } else {
        if (!limits_.continuous(state, {q, qd}, period_)) {
            return StopReason::Singularity;
        }
        state.q = q;
    }
    state.qd = qd;
    tool_ = tool;
    const double wanted = targetVelocity_.norm();
    if (slowedBy_ < 0.5 && wanted > 1e-6 && velocity_.norm() < 0.01 * wanted &&
        qd.cwiseAbs().maxCoeff() < 10 * kCreeping) {
        return rangeLimited ? StopReason::JointPositionLimit : StopReason::Singularity;
    }
    return std::nullopt;
}

std::optional<StopReason> VelocityMotion::stepServoJ(double timeScale, JointTarget& state, int& joint) {
    const double dt = period_ * timeScale;
    // Feed-forward of the target velocity avoids a lag at constant speed. It is filtered over a fifth of the
    // lookahead time. The gain is the stiffness. The damping is lookahead time times gain, but at least 90 %
    // of critical damping.
    servoFiltered_ += (servoRate_ - servoFiltered_) * (dt / (0.2 * lookahead_ + dt));
    const double K = gain_;
    const double D = std::max(gain_ * lookahead_, 1.8 * std::sqrt(gain_));
    servoQ_ = servoQ_.cwiseMin(limits_.position - kRangeReserve).cwiseMax(-limits_.position + kRangeReserve);
    const Vector6 error = servoQ_ - state.q;
    // Implicit integration is stable for every gain and period.
    Vector6 next = (velocity_ + dt * (K * error + D * servoFiltered_)) / (1 + D * dt + K * dt * dt);
    next = next.cwiseMin(limits_.speed).cwiseMax(-limits_.speed);
    for (int j = 0; j < kJointCount; ++j) {
        // Limit the speed to the target speed plus the speed from which the joint can stop at the target.
        const double stopping = std::sqrt(limits_.acceleration * std::abs(error[j])) +
                                std::abs(servoFiltered_[j]) + limits_.acceleration * period_;
        next[j] = std::clamp(next[j], -stopping, stopping);
        // Each joint is limited separately, so that a joint whose target jumps does not delay the others.
        const double reachable = limits_.acceleration * dt;
        next[j] = std::clamp(next[j], velocity_[j] - reachable, velocity_[j] + reachable);
    }
    Vector6 wanted = next * timeScale;
    double factor = limits_.speedFactor(wanted);
    factor *= limits_.rangeFactor(state.q, wanted * factor, period_, joint);
    joint = -1;
    slowedBy_ = factor;
    wanted *= factor;
    next *= factor;
    if (limits_.cutToAcceleration(state.qd, wanted, period_) && timeScale > kNoScale) {
        next = wanted / timeScale;
    }
    velocity_ = next;
    state.q += 0.5 * (state.qd + wanted) * period_;
    state.qd = wanted;
    return std::nullopt;
}

}  // namespace tiller::simulator::arm
