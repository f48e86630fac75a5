// SPDX-License-Identifier: MIT
#include "robot/collision/arm_body.h"

#include <algorithm>
#include <cmath>

#include "robot/kinematics/arm_kinematics.h"

namespace tiller::collision {
namespace {

struct Offsets {
    double shoulder;
    double elbow;
};

Offsets offsetsOf(RobotModelId id) {
    switch (id) {
        case RobotModelId::UR3:
            return {0.1198, 0.0273};
        case RobotModelId::UR5:
            return {0.1359, 0.0162};
        case RobotModelId::UR10:
            return {0.2209, 0.0490};
        case RobotModelId::UR3e:
            return {0.1200, 0.0270};
        case RobotModelId::UR5e:
        case RobotModelId::UR7e:
            return {0.1380, 0.0070};
        case RobotModelId::UR10e:
        case RobotModelId::UR12e:
        case RobotModelId::UR16e:
            return {0.1760, 0.0390};
        case RobotModelId::UR8Long:
        case RobotModelId::UR15:
        case RobotModelId::UR18:
            return {0.2080, 0.0510};
        case RobotModelId::UR20:
        case RobotModelId::UR30:
            return {0.2600, 0.0430};
    }
    return {};
}

/// Housing radius [m] for a joint torque [Nm].
double housingRadius(double torque) {
    constexpr double kThinnest = 0.0315;
    return std::max(kThinnest, 0.0112 * std::cbrt(torque) + 0.0020);
}

}  // namespace

ArmProportions armProportions(const RobotModel& model) {
    const Offsets offsets = offsetsOf(model.id);
    ArmProportions p;
    p.shoulderOffset = offsets.shoulder;
    p.elbowOffset = offsets.elbow;
    p.shoulderRadius = housingRadius(model.maxTorque[1]);
    p.elbowRadius = std::min(0.94 * p.shoulderRadius, housingRadius(model.maxTorque[2]));
    p.wristRadius = housingRadius(model.maxTorque[3]);
    p.upperRadius = 0.80 * p.shoulderRadius;
    p.foreRadius = std::max(0.70 * p.elbowRadius, 0.98 * p.wristRadius);
    p.baseRadius = 1.06 * p.shoulderRadius;
    p.baseHeight = std::max(0.25 * model.dh.d[0], model.dh.d[0] - 1.12 * p.shoulderRadius);
    p.flangeRadius = 0.88 * p.wristRadius;
    return p;
}

double uprightHeight(const RobotModel& model) {
    return model.dh.d[0] + std::abs(model.dh.a[1]) + std::abs(model.dh.a[2]) + model.dh.d[4];
}

std::vector<LinkCapsule> armCapsules(const RobotModel& model) {
    const ArmProportions p = armProportions(model);
    const DhParameters& dh = model.dh;
    const double upper = std::abs(dh.a[1]);
    const double fore = std::abs(dh.a[2]);
    // The edges of a cylindrical housing extend beyond a capsule of the same radius, so the capsule is larger
    // by this factor.
    constexpr double kDrum = 1.15;
    constexpr double kHalf = 0.5;  // half length of the capsule in units of its radius
    const auto drum = [](int link, const Eigen::Vector3d& centre, int axis, double radius) {
        const Eigen::Vector3d half = Eigen::Vector3d::Unit(axis) * (kHalf * radius);
        return LinkCapsule{link, {centre - half, centre + half, kDrum * radius}, 1, false};
    };
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
    const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
    LinkCapsule joint2 = drum(2, x * upper + z * p.shoulderOffset, 2, p.shoulderRadius);
    joint2.neighbours = 2;
    const double baseTop = std::max(0.0, p.baseHeight - 0.3 * p.baseRadius);
    return {
        {0, {z * std::min(0.7 * p.baseRadius, baseTop), z * baseTop, 1.12 * p.baseRadius}, 1, true},
        {1, {y * (p.baseHeight - dh.d[0]), y * (0.5 * p.shoulderRadius), 1.12 * p.shoulderRadius}, 1, true},
        {1, {z * 0.0, z * (p.shoulderOffset - 1.3 * p.shoulderRadius), 1.04 * p.shoulderRadius}, 1, false},
        joint2,
        {2, {x * upper + z * p.shoulderOffset, z * p.shoulderOffset, 1.12 * p.upperRadius}, 1, false},
        drum(2, z * p.shoulderOffset, 2, p.elbowRadius),
        {3,
         {x * fore + z * (p.shoulderOffset - 1.5 * p.elbowRadius), x * fore + z * p.elbowOffset,
          1.04 * p.elbowRadius},
         1,
         false},
        {3, {x * fore + z * p.elbowOffset, z * p.elbowOffset, 1.12 * p.foreRadius}, 1, false},
        drum(3, z * p.elbowOffset, 2, p.wristRadius),
        {4, {y * (p.elbowOffset + 1.4 * p.wristRadius - dh.d[3]), y * 0.0, 1.02 * p.wristRadius}, 1, false},
        drum(4, Eigen::Vector3d::Zero(), 2, p.wristRadius),
        {5, {y * (dh.d[4] - 1.4 * p.wristRadius), y * 0.0, 1.02 * p.wristRadius}, 1, false},
        drum(5, Eigen::Vector3d::Zero(), 2, p.wristRadius),
        {6,
         {z * (1.2 * p.wristRadius - dh.d[5]), z * (-0.62 * p.flangeRadius), 1.12 * p.flangeRadius},
         1,
         false},
    };
}

std::vector<LinkCapsule> placedCapsules(const std::vector<LinkCapsule>& capsules, const DhParameters& dh,
                                        const JointPositions& q) {
    const auto frames = kinematics::linkFrames(dh, q);
    std::vector<LinkCapsule> placed = capsules;
    for (LinkCapsule& part : placed) {
        const Eigen::Isometry3d& frame = frames[static_cast<std::size_t>(part.link)];
        part.shape.from = frame * part.shape.from;
        part.shape.to = frame * part.shape.to;
    }
    return placed;
}

}  // namespace tiller::collision
