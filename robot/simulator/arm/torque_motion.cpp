// SPDX-License-Identifier: MIT
#include "robot/simulator/arm/torque_motion.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace tiller::simulator::arm {

namespace {
// Friction of the gears. The values are within the range of published identifications.
const Vector6 kViscous = (Vector6() << 14, 14, 10, 4, 4, 4).finished();  // Nm s/rad
const Vector6 kCoulomb = (Vector6() << 8, 8, 6, 2, 2, 2).finished();     // Nm
constexpr double kStickSpeed = 0.02;                                     // rad/s
}  // namespace

void TorqueMotion::command(const JointTorques& torques, const Vector6& viscousScale,
                           const Vector6& coulombScale) {
    torques_ = torques.values;
    viscous_ = kViscous.cwiseProduct((1 - viscousScale.array().max(0).min(1)).matrix());
    coulomb_ = kCoulomb.cwiseProduct((1 - coulombScale.array().max(0).min(1)).matrix());
}

std::optional<StopReason> TorqueMotion::step(double period, const JointLimits& limits, JointTarget& state,
                                             int& joint) {
    const Matrix6 mass = dynamics_.massMatrix(state.q, true);
    const Vector6 free = torques_ + external_ - dynamics_.coriolis(state.q, state.qd);
    // Friction is integrated implicitly, because it can stop a joint but must not reverse it.
    Matrix6 effective = mass;
    for (int j = 0; j < kJointCount; ++j) {
        effective(j, j) += period * (viscous_[j] + coulomb_[j] / (kStickSpeed + std::abs(state.qd[j])));
    }
    Vector6 next = effective.ldlt().solve(mass * state.qd + period * free);
    limits.cutToAcceleration(state.qd, next, period);
    Eigen::Index fastest = 0;
    if ((next.cwiseAbs() - limits.speed).maxCoeff(&fastest) > 0) {
        joint = static_cast<int>(fastest);
        return StopReason::JointSpeedLimit;
    }
    const double factor = limits.rangeFactor(state.q, next, period, joint);
    if (factor < 0.999) {
        return StopReason::JointPositionLimit;
    }
    state.q += 0.5 * (state.qd + next) * period;
    state.qd = next;
    return std::nullopt;
}

}  // namespace tiller::simulator::arm
