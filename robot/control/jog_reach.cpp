// SPDX-License-Identifier: MIT
#include "robot/control/jog_reach.h"

#include <algorithm>
#include <numbers>
#include <optional>

#include "robot/control/detail/velocity_limiter.h"
#include "robot/kinematics/arm_kinematics.h"

namespace tiller::control {
namespace {

// Speeds of the simulated jog. A slower jog ends a few tenths of a millimetre closer to the limits.
constexpr double kFollowSpeed = 0.25;                      // [m/s]
constexpr double kFollowTurnSpeed = std::numbers::pi / 4;  // [rad/s]
constexpr double kFollowStep = 0.010;                      // [m]; step size far from limits
constexpr double kFollowTurnStep = 0.030;                  // [rad]
constexpr double kSlowedStep = 0.2;  // fraction of a step used where the jog is slowed down
constexpr double kSlowed = 0.7;
constexpr int kFollowHalvings = 12;  // number of bisections of the final step
// Larger joint changes within a step indicate a singularity [rad].
constexpr double kFollowJump = 0.5;

Pose movedBy(const Pose& pose, const Vector6& direction, double by) {
    Pose next = pose;
    next.position += direction.head<3>() * by;
    if (const Eigen::Vector3d axis = direction.tail<3>(); !axis.isZero()) {
        next.rotation = rotationVector(Eigen::AngleAxisd(by, axis) * rotationMatrix(pose.rotation));
    }
    return next;
}

}  // namespace

JointLimits jointLimitsOf(const RobotModel& model) {
    const ArmLimits arm = ArmLimits::of(model);
    return {arm.minPosition, arm.maxPosition, arm.maxSpeed};
}

JogReach jogReach(const JogConditions& arm, const JointPositions& q, const Pose& tcpOffset,
                  const Vector6& direction, double farthest) {
    ArmLimits limits;
    limits.dh = arm.dh;
    limits.minPosition = arm.joints.minPosition;
    limits.maxPosition = arm.joints.maxPosition;
    limits.maxSpeed = arm.joints.maxSpeed;
    MotionLimits uncapped = arm.limits;
    uncapped.tcpSpeed = kNoCap;
    uncapped.tcpRotationSpeed = kNoCap;
    const VelocityLimiter limiter(limits, uncapped);
    const bool turns = !direction.tail<3>().isZero();
    JogTarget target;
    target.twist = {direction.head<3>() * kFollowSpeed, direction.tail<3>() * kFollowTurnSpeed};
    const Pose start = kinematics::forwardTcp(arm.dh, q, tcpOffset);

    struct Place {
        JointPositions q;
        Limiter limiter;
    };
    // Empty if the position is unreachable or reachable only with a jump.
    const auto placeAt = [&](double gone, const JointPositions& near) -> std::optional<Place> {
        const Pose pose = movedBy(start, direction, gone);
        // Ignores joint ranges, which the limiter checks.
        const auto next =
            gone == 0 ? std::optional(q)
                      : kinematics::inverseNearest(arm.dh, pose, tcpOffset, near, 4 * kJointPositionLimit);
        if (!next || (next->values - near.values).cwiseAbs().maxCoeff() > kFollowJump) {
            return std::nullopt;
        }
        return Place{*next, limiter.limit(target, *next, pose, {{}, arm.check})};
    };

    JogReach reach;
    reach.end.kind = LimiterKind::Singularity;
    Place at{q, {}};
    double step = 0;
    while (true) {
        const double next = std::min(reach.distance + step, farthest);
        const std::optional<Place> place = placeAt(next, at.q);
        if (!place || place->limiter.scale <= 0) {
            if (place) {
                reach.end = place->limiter;
            }
            double beyond = next;
            for (int i = 0; i < kFollowHalvings && beyond > reach.distance; ++i) {
                const double middle = (reach.distance + beyond) / 2;
                const std::optional<Place> between = placeAt(middle, at.q);
                if (between && between->limiter.scale > 0) {
                    reach.distance = middle;
                    at = *between;
                    continue;
                }
                beyond = middle;
                if (between) {
                    reach.end = between->limiter;
                }
            }
            return reach;
        }
        at = *place;
        reach.distance = next;
        if (next >= farthest) {
            reach.end = {};
            return reach;
        }
        step = (turns ? kFollowTurnStep : kFollowStep) * (at.limiter.scale < kSlowed ? kSlowedStep : 1);
    }
}

}  // namespace tiller::control
