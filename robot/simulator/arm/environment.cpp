// SPDX-License-Identifier: MIT
#include "robot/simulator/arm/environment.h"

#include <algorithm>
#include <cmath>

namespace tiller::simulator::arm {

bool Environment::addPlane(const ContactPlane& plane) {
    const double length = plane.normal.norm();
    if (planeCount_ >= kMaxPlanes || !plane.point.allFinite() || !std::isfinite(length) || length < 1e-9 ||
        !(plane.stiffness > 0) || !(plane.damping >= 0) || !(plane.friction >= 0)) {
        return false;
    }
    ContactPlane& added = planes_[static_cast<std::size_t>(planeCount_++)];
    added = plane;
    added.normal /= length;
    return true;
}

Eigen::Vector3d Environment::contactForce(const Eigen::Vector3d& position,
                                          const Eigen::Vector3d& velocity) const {
    constexpr double kStickSpeed = 0.005;  // m/s: friction grows to its full value over this
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    for (int i = 0; i < planeCount_; ++i) {
        const ContactPlane& plane = planes_[static_cast<std::size_t>(i)];
        const double depth = plane.normal.dot(plane.point - position);
        if (depth <= 0) {
            continue;
        }
        const double approach = -plane.normal.dot(velocity);
        // A surface pushes, it does not pull.
        const double normal = std::max(0.0, plane.stiffness * depth + plane.damping * approach);
        const Eigen::Vector3d sliding = velocity + plane.normal * approach;
        const double speed = sliding.norm();
        force += plane.normal * normal - sliding * (plane.friction * normal / std::max(speed, kStickSpeed));
    }
    return force;
}

}  // namespace tiller::simulator::arm
