// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/arm_shape.h"

#include <cmath>

#include "robot/kinematics/arm_kinematics.h"

namespace tiller {

double uprightHeight(const RobotModel& model) {
    return model.dh.d[0] + std::abs(model.dh.a[1]) + std::abs(model.dh.a[2]) + model.dh.d[4];
}

std::array<ArmPart, kArmPartCount> armParts(const RobotModel& model, const JointPositions& q) {
    const auto frames = kinematics::linkFrames(model.dh, q);
    const auto origin = [&](std::size_t i) -> Eigen::Vector3d { return frames[i].translation(); };
    const auto axis = [&](std::size_t i) -> Eigen::Vector3d { return frames[i].linear().col(2); };
    // The upper arm runs beside the shoulder, the forearm beside the upper arm: distances along the parallel
    // axes 2 and 3, in proportion to d4 as on a UR5e (0.138 m and 0.007 m).
    const double d4 = model.dh.d[3];
    const Eigen::Vector3d upper = axis(1) * (1.035 * d4);
    const Eigen::Vector3d fore = axis(1) * (0.0525 * d4);

    const Eigen::Vector3d shoulder = origin(1);
    const Eigen::Vector3d upperStart = shoulder + upper;
    const Eigen::Vector3d upperEnd = origin(2) + upper;
    const Eigen::Vector3d foreStart = origin(2) + fore;
    const Eigen::Vector3d foreEnd = origin(3) + fore;
    const Eigen::Vector3d wrist1 = origin(4);
    const Eigen::Vector3d wrist2 = origin(5);
    const Eigen::Vector3d flange = origin(6);

    const double s = model.reach / 0.85;
    using Kind = ArmPartKind;
    const Eigen::Vector3d out = axis(1);
    const Eigen::Vector3d all = Eigen::Vector3d::Zero();
    enum : unsigned {
        ShoulderRod = 1,
        UpperArm = 2,
        ElbowRod = 3,
        Forearm = 4,
        Wrist1 = 5,
        Wrist2 = 6,
        Wrist3 = 7
    };
    const auto bits = [](unsigned a, unsigned b) { return 1U << a | 1U << b; };
    return {{
        {Kind::Housing, origin(0) + Eigen::Vector3d(0, 0, 0.05 * s), shoulder, 0.057 * s, 0, all},
        {Kind::Housing, shoulder, upperStart, 0.059 * s, 0, all},
        {Kind::Link, upperStart, upperEnd, 0.047 * s, 0, all},
        {Kind::Housing, upperEnd, foreStart, 0.048 * s, 0, all},
        {Kind::Link, foreStart, foreEnd, 0.040 * s, 0, all},
        {Kind::Housing, foreEnd, wrist1, 0.034 * s, 0, all},
        {Kind::Housing, wrist1, wrist2, 0.032 * s, 0, all},
        {Kind::Housing, wrist2, wrist2 + 0.8 * (flange - wrist2), 0.030 * s, 0, all},
        {Kind::Joint, upperStart, upperStart, 0.064 * s, bits(ShoulderRod, UpperArm), out},
        {Kind::Joint, upperEnd, upperEnd, 0.053 * s, bits(UpperArm, ElbowRod), out},
        {Kind::Joint, foreEnd, foreEnd, 0.045 * s, bits(Forearm, Wrist1), all},
        {Kind::Joint, wrist1, wrist1, 0.040 * s, bits(Wrist1, Wrist2), all},
        {Kind::Joint, wrist2, wrist2, 0.038 * s, bits(Wrist2, Wrist3), all},
    }};
}

}  // namespace tiller
