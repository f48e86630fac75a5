// SPDX-License-Identifier: MIT
#include "robot/simulator/arm/joint_limits.h"

#include <algorithm>
#include <cmath>

namespace tiller::simulator::arm {

namespace {
// 1/s. Near the end of the joint range, the speed limit is this value times the distance from the end. All
// joints stop together, so the limit must leave enough time for the fastest joint of any model to stop from
// full speed.
constexpr double kCreepRate = 12;
}  // namespace

double JointLimits::speedFactor(const Vector6& qd) const {
    const double worst = (qd.cwiseAbs().array() / speed.array()).maxCoeff();
    return worst > 1 ? 1 / worst : 1.0;
}

double JointLimits::rangeFactor(const Vector6& q, const Vector6& qd, double period, int& joint) const {
    double factor = 1;
    for (int j = 0; j < kJointCount; ++j) {
        const double v = std::abs(qd[j]);
        if (v < 1e-12) {
            continue;
        }
        const double left = position - kRangeReserve - (qd[j] > 0 ? q[j] : -q[j]);
        const double room = std::max(0.0, left - v * period);
        const double allowed = std::min(std::sqrt(2 * brakingAcceleration() * room), kCreepRate * room);
        if (allowed < factor * v) {
            factor = allowed / v;
            joint = j;
        }
    }
    return factor;
}

bool JointLimits::cutToAcceleration(const Vector6& from, Vector6& to, double period) const {
    const double change = (to - from).cwiseAbs().maxCoeff();
    const double possible = acceleration * period;
    if (change <= possible) {
        return false;
    }
    to = from + (to - from) * (possible / change);
    return true;
}

bool JointLimits::continuous(const JointTarget& from, const JointTarget& to, double period) const {
    const Vector6 jump = to.q - from.q - 0.5 * (from.qd + to.qd) * period;
    return jump.cwiseAbs().maxCoeff() <= acceleration * period * period;
}

}  // namespace tiller::simulator::arm
