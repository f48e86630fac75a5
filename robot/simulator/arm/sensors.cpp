// SPDX-License-Identifier: MIT
#include "robot/simulator/arm/sensors.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace tiller::simulator::arm {

namespace {
constexpr double kTrackingTime = 0.002;       // s, lag of the position control
constexpr double kEncoderNoise = 4e-6;        // rad
constexpr double kEncoderRest = 1e-4;         // rad/s
constexpr double kVelocityNoise = 1e-4;       // rad/s
constexpr double kCurrentNoise = 0.012;       // A
constexpr double kForceNoise = 0.12;          // N
constexpr double kTorqueNoise = 0.006;        // Nm
constexpr double kAccelerometerNoise = 0.02;  // m/s2
constexpr double kAllowedDeviation = 0.15;    // rad between target and actual
constexpr double kAmbient = 23.0;             // degC
constexpr double kWarmUp = 1500.0;            // s
constexpr double kHeatPerSquareAmpere = 1.1;  // K/A2
constexpr double kHeatOfElectronics = 6.0;    // K
constexpr double kSupplyVoltage = 48.0;       // V
constexpr double kIdlePower = 40.0;           // W, electronics of the joints
constexpr double kResistance = 1.4;           // ohm, relative to joint current
constexpr double kRounding = 1e-9;            // tolerance relative to an acceleration, and absolute in rad/s2
// Initial values recorded from the manufacturer's simulator.
const Vector6 kStartTemperature = (Vector6() << 25.5, 25.0, 24.5, 24.0, 23.5, 23.5).finished();

/// Acceleration as a difference of velocities without rounding errors. Clients evaluate the sign of
/// differences between readings, so a constant acceleration must result in constant readings.
Vector6 withoutRounding(const Vector6& acceleration, const Vector6& before) {
    const auto change = (acceleration - before).array().abs();
    return (change <= kRounding * (1 + before.array().abs())).select(before, acceleration);
}
}  // namespace

double Noise::uniform() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return static_cast<double>(state_ >> 11) * 0x1.0p-53;
}

double Noise::operator()(double standardDeviation) {
    const double sum = uniform() + uniform() + uniform() + uniform() - 2.0;
    return scale_ * sum * standardDeviation * 1.7320508075688772;
}

Eigen::Vector3d Noise::vector(double standardDeviation) {
    const double x = (*this)(standardDeviation);
    const double y = (*this)(standardDeviation);
    return {x, y, (*this)(standardDeviation)};
}

Sensors::Sensors(const ArmGeometry& geometry, double period, std::uint64_t seed, bool ideal)
    : geometry_(geometry)
    , period_(period)
    , ideal_(ideal)
    , noise_(seed)
    , model_(geometry.model())
    , real_(geometry.model()) {
    if (!ideal_) {
        offset_ = {{0.9, -1.4, 2.3}, {0.05, -0.03, 0.02}};
    }
}

void Sensors::setGravity(const Eigen::Vector3d& gravity) {
    gravity_ = gravity;
    model_.setGravity(gravity);
    real_.setGravity(gravity);
}

void Sensors::setPayload(const Payload& payload) {
    if (loadHangs_) {
        // The sensor may be zeroed directly after this call, so the new payload must already be in effect.
        const Wrench before = loadOnFlange(payload_);
        const Wrench now = loadOnFlange(payload);
        compensated_ = {compensated_.force + before.force - now.force,
                        compensated_.torque + before.torque - now.torque};
    }
    payload_ = payload;
    model_.setPayload(payload);
}

void Sensors::zeroForce() {
    zero_ = compensated_;
}

void Sensors::place(const Vector6& q) {
    q_ = q;
    qd_.setZero();
    qdd_.setZero();
    first_ = true;
}

void Sensors::update(const JointTarget& target, DriveState drive, const Environment& environment,
                     ArmState& state) {
    loadHangs_ = environment.load().has_value();
    const Payload& load = loadHangs_ ? *environment.load() : payload_;
    if (!(load == load_)) {
        load_ = load;
        real_.setPayload(load);
    }
    updateKinematics(target, state);
    updateForces(environment, drive, state);
    updateDrives(drive, state);
    updateSupply(drive, state);
    first_ = false;
}

void Sensors::updateKinematics(const JointTarget& target, ArmState& state) {
    const Vector6 qdd =
        first_ ? Vector6::Zero()
               : withoutRounding((target.qd - state.targetQd.values) / period_, state.targetQdd.values);
    const Vector6 qdBefore = qd_;
    if (ideal_ || first_) {
        q_ = target.q;
        qd_ = target.qd;
    } else {
        const double follow = 1 - std::exp(-period_ / kTrackingTime);
        q_ += follow * (target.q - q_);
        qd_ += follow * (target.qd - qd_);
    }
    qdd_ = first_ ? Vector6::Zero() : Vector6((qd_ - qdBefore) / period_);
    state.targetQ.values = target.q;
    state.targetQd.values = target.qd;
    state.targetQdd.values = qdd;
    state.actualQ.values = q_;
    state.actualQd.values = qd_;
    if (!ideal_) {
        for (int j = 0; j < kJointCount; ++j) {
            // At standstill, the encoder readings of a joint do not change.
            if (std::abs(qd_[j]) > kEncoderRest) {
                state.actualQ[j] += noise_(kEncoderNoise);
            }
            state.actualQd[j] += noise_(kVelocityNoise);
        }
    }
    state.positionDeviationRatio =
        (state.targetQ.values - state.actualQ.values).cwiseAbs().maxCoeff() / kAllowedDeviation;

    geometry_.evaluate(target.q, target_);
    geometry_.evaluate(state.actualQ.values, actual_);
    const Twist targetTwist = Twist::fromVector(target_.jacobian * target.qd);
    const Twist actualTwist = Twist::fromVector(actual_.jacobian * state.actualQd.values);
    const auto rate = [&](const Twist& now, const Twist& before) -> Twist {
        if (first_) {
            return {};
        }
        return {(now.linear - before.linear) / period_, (now.angular - before.angular) / period_};
    };
    state.targetTcpPose = Pose(target_.T_base_tcp);
    state.targetTcpSpeed = targetTwist;
    state.targetTcpAcceleration = rate(targetTwist, targetTwist_);
    state.actualTcpPose = Pose(actual_.T_base_tcp);
    state.actualTcpSpeed = actualTwist;
    state.actualTcpAcceleration = rate(actualTwist, actualTwist_);
    state.actualFlangePose = Pose(actual_.frames[6]);
    targetTwist_ = targetTwist;
    actualTwist_ = actualTwist;

    const Eigen::Vector3d z1 = actual_.frames[0].linear().col(2);
    const Eigen::Vector3d z2 = actual_.frames[1].linear().col(2);
    const Eigen::Vector3d elbow = actual_.frames[2].translation();
    state.elbowPosition = elbow;
    state.elbowVelocity = z1.cross(elbow - actual_.frames[0].translation()) * state.actualQd[0] +
                          z2.cross(elbow - actual_.frames[1].translation()) * state.actualQd[1];
    state.momentum = real_.momentum(actual_.frames, state.actualQd.values).linear.norm();
    updateBase(target, state);
}

// Load on the base: the weight and the change of momentum.
void Sensors::updateBase(const JointTarget& target, ArmState& state) {
    const Dynamics::Momentum now = model_.momentum(target_.frames, target.qd);
    const Eigen::Vector3d force = first_ ? Eigen::Vector3d::Zero() : Eigen::Vector3d(now.linear - linear_);
    const Eigen::Vector3d torque = first_ ? Eigen::Vector3d::Zero() : Eigen::Vector3d(now.angular - angular_);
    state.targetBaseWrench = {now.mass * gravity_ + force / period_,
                              now.firstMoment.cross(gravity_) + torque / period_};
    linear_ = now.linear;
    angular_ = now.angular;
}

// Acceleration of a point fixed to the flange, from the target motion, which is free of noise. The actual
// motion differs only by the lag.
Eigen::Vector3d Sensors::accelerationOf(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d w = targetTwist_.angular;
    const Eigen::Vector3d arm = point - target_.T_base_tcp.translation();
    return tcpAcceleration_ + tcpTurning_.cross(arm) + w.cross(w.cross(arm));
}

// Weight and inertia of a load, as they act on the flange (flange frame, about its origin).
Wrench Sensors::loadOnFlange(const Payload& load) const {
    if (load.mass <= 0) {
        return {};
    }
    const Eigen::Matrix3d& R = target_.frames[6].linear();
    const Eigen::Vector3d centre = target_.frames[6].translation() + R * load.centreOfGravity;
    const Eigen::Vector3d acceleration = accelerationOf(centre);
    const Eigen::Vector3d force = R.transpose() * (-load.mass * (gravity_ + acceleration));
    return {force, load.centreOfGravity.cross(force)};
}

void Sensors::updateForces(const Environment& environment, DriveState drive, ArmState& state) {
    tcpAcceleration_ = state.targetTcpAcceleration.linear;
    tcpTurning_ = state.targetTcpAcceleration.angular;
    const Eigen::Matrix3d R = actual_.frames[6].linear();
    const Eigen::Vector3d tcp = geometry_.tcpTransform().translation();

    const Eigen::Vector3d position = actual_.T_base_tcp.translation();
    const Vector6 twist = actual_.jacobian * qd_;
    const Eigen::Vector3d push = environment.contactForce(position, twist.head<3>());
    contact_ = push.norm();
    const Wrench& hand = environment.handWrench();
    external_.force = R.transpose() * (push + hand.force);
    external_.torque = R.transpose() * hand.torque + tcp.cross(external_.force);

    const Wrench carried = loadOnFlange(load_);
    const Wrench known = loadOnFlange(payload_);
    atFlange_ = {external_.force + carried.force, external_.torque + carried.torque};
    Wrench reading = atFlange_;
    if (!ideal_) {
        reading.force += noise_.vector(kForceNoise);
        reading.torque += noise_.vector(kTorqueNoise);
    }
    state.ftRawWrench = {reading.force + offset_.force, reading.torque + offset_.torque};
    compensated_ = {reading.force - known.force, reading.torque - known.torque};
    const Eigen::Vector3d force = compensated_.force - zero_.force;
    const Eigen::Vector3d torque = compensated_.torque - zero_.torque;
    state.tcpForce = {R * force, R * (torque - tcp.cross(force))};
    state.tcpForceScalar = state.tcpForce.force.norm();

    const Eigen::Vector3d weight = R * (carried.force - known.force);
    const Eigen::Vector3d moment = R * (carried.torque - known.torque);
    unexplained_ = {push + hand.force + weight, hand.torque + moment - (R * tcp).cross(weight)};

    // The accelerometer in the flange measures the reaction to gravity.
    const bool powered = drive != DriveState::Off;
    state.toolAccelerometer =
        powered
            ? Eigen::Vector3d(R.transpose() * (gravity_ + accelerationOf(target_.frames[6].translation())))
            : Eigen::Vector3d::Zero();
    if (powered && !ideal_) {
        state.toolAccelerometer += noise_.vector(kAccelerometerNoise);
    }
}

void Sensors::updateDrives(DriveState drive, ArmState& state) {
    if (drive != DriveState::Running) {
        // The brakes hold the arm.
        needed_.setZero();
        state.targetMoment = state.actualMoment = state.externalTorque = JointTorques();
        state.targetCurrent.setZero();
        state.actualCurrent.setZero();
        state.jointControlOutput.setZero();
        state.wrenchFromCurrents = {};
        return;
    }
    const Vector6 expected =
        model_.torques(state.targetQ.values, state.targetQd.values, state.targetQdd.values);
    needed_ = real_.torques(q_, qd_, qdd_, external_);
    const Vector6& needed = needed_;
    const auto perCurrent = Eigen::Map<const Vector6>(geometry_.model().torquePerCurrent.data());
    state.targetMoment.values = expected;
    state.targetCurrent = expected.cwiseQuotient(perCurrent);
    state.actualCurrent = needed.cwiseQuotient(perCurrent);
    if (!ideal_) {
        for (int j = 0; j < kJointCount; ++j) {
            state.actualCurrent[j] += noise_(kCurrentNoise);
        }
    }
    state.actualMoment.values = state.actualCurrent.cwiseProduct(perCurrent);
    state.jointControlOutput = state.actualCurrent;
    state.actualCurrentWindow = (0.15 * state.targetCurrent.cwiseAbs()).array() + 1.0;
    // External torque that the model does not predict. The noise-free torques correspond to the filtered
    // values of a controller.
    state.externalTorque.values = needed - expected;
    const Matrix6 J = actual_.jacobian;
    const Matrix6 damped = J * J.transpose() + 1e-6 * Matrix6::Identity();
    state.wrenchFromCurrents = Wrench::fromVector(-damped.llt().solve(J * state.externalTorque.values));
}

Vector6 Sensors::unexplainedTorques() const {
    return actual_.jacobian.transpose() * unexplained_.vector();
}

int Sensors::overloadedJoint() {
    const auto most = Eigen::Map<const Vector6>(geometry_.model().maxTorque.data());
    if ((needed_.cwiseAbs().array() <= most.array()).all()) {
        return -1;
    }
    // Checks only the static load, because hard braking may briefly exceed the limits.
    const Vector6 holding = real_.torques(q_, Vector6::Zero(), Vector6::Zero(), external_);
    Eigen::Index joint = 0;
    return (holding.cwiseAbs().array() - most.array()).maxCoeff(&joint) > 0 ? static_cast<int>(joint) : -1;
}

void Sensors::updateSupply(DriveState drive, ArmState& state) {
    const bool powered = drive != DriveState::Off;
    if (state.controlStep <= 1) {
        state.jointTemperature = kStartTemperature;
        state.toolTemperature = kStartTemperature[5];
    }
    double power = powered ? kIdlePower : 0;
    for (int j = 0; j < kJointCount; ++j) {
        const double current = state.actualCurrent[j];
        const double settled =
            kAmbient + (powered ? kHeatOfElectronics : 0.0) + kHeatPerSquareAmpere * current * current;
        state.jointTemperature[j] += (settled - state.jointTemperature[j]) * period_ / kWarmUp;
        state.jointVoltage[j] = powered ? kSupplyVoltage - 0.05 * std::abs(current) : 0.0;
        power += std::max(0.0, state.actualMoment[j] * qd_[j]) + kResistance * current * current;
    }
    const double settledTool = kAmbient + (powered ? kHeatOfElectronics : 0.0);
    state.toolTemperature += (settledTool - state.toolTemperature) * period_ / kWarmUp;
    state.mainVoltage = kSupplyVoltage;
    state.robotVoltage = powered ? kSupplyVoltage : 0.0;
    state.robotCurrent = power / kSupplyVoltage;
    state.toolCurrent = powered ? 0.06 : 0.0;
    if (!ideal_ && powered) {
        state.robotVoltage += noise_(0.02);
        state.robotCurrent = std::max(0.0, state.robotCurrent + noise_(0.01));
    }
    state.energyConsumed += power * period_;
    for (int j = 0; j < kJointCount; ++j) {
        state.energyBraked += std::max(0.0, -state.actualMoment[j] * qd_[j]) * period_;
    }
}

}  // namespace tiller::simulator::arm
