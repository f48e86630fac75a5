// SPDX-License-Identifier: MIT
#include "robot/simulator/arm/environment.h"

#include <algorithm>
#include <cmath>

namespace tiller::simulator::arm {

namespace {

bool makesSense(const ContactMaterial& m) {
    return m.stiffness > 0 && m.damping >= 0 && m.friction >= 0 && std::isfinite(m.stiffness) &&
           std::isfinite(m.damping) && std::isfinite(m.friction);
}

// Force that a surface with this outward normal exerts on a point at `depth` below the surface.
Eigen::Vector3d push(const ContactMaterial& material, const Eigen::Vector3d& normal, double depth,
                     const Eigen::Vector3d& velocity) {
    constexpr double kStickSpeed = 0.005;  // m/s: friction reaches its full value at this speed
    const double approach = -normal.dot(velocity);
    // A surface can push but cannot pull.
    const double force = std::max(0.0, material.stiffness * depth + material.damping * approach);
    const Eigen::Vector3d sliding = velocity + normal * approach;
    return normal * force - sliding * (material.friction * force / std::max(sliding.norm(), kStickSpeed));
}

}  // namespace

bool Environment::addPlane(const ContactPlane& plane) {
    const double length = plane.normal.norm();
    if (planeCount_ >= kMaxPlanes || !plane.point.allFinite() || !std::isfinite(length) || length < 1e-9 ||
        !makesSense(plane.material)) {
        return false;
    }
    ContactPlane& added = planes_[static_cast<std::size_t>(planeCount_++)];
    added = plane;
    added.normal /= length;
    return true;
}

bool Environment::addBox(const ContactBox& box) {
    if (boxCount_ >= kMaxBoxes || !box.T_base_box.allFinite() || !box.size.allFinite() ||
        box.size.minCoeff() <= 0 || !makesSense(box.material)) {
        return false;
    }
    boxes_[static_cast<std::size_t>(boxCount_++)] = {box.T_base_box.transform(), 0.5 * box.size,
                                                     box.material};
    return true;
}

void Environment::setConveyorSpeed(int encoder, double ticksPerSecond) {
    if (encoder >= 0 && encoder < 2 && std::isfinite(ticksPerSecond)) {
        conveyorSpeeds_[static_cast<std::size_t>(encoder)] = ticksPerSecond;
    }
}

Eigen::Vector3d Environment::contactForce(const Eigen::Vector3d& position,
                                          const Eigen::Vector3d& velocity) const {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    for (int i = 0; i < planeCount_; ++i) {
        const ContactPlane& plane = planes_[static_cast<std::size_t>(i)];
        const double depth = plane.normal.dot(plane.point - position);
        if (depth > 0) {
            force += push(plane.material, plane.normal, depth, velocity);
        }
    }
    for (int i = 0; i < boxCount_; ++i) {
        const Box& box = boxes_[static_cast<std::size_t>(i)];
        const Eigen::Vector3d inside = box.T_base_box.inverse() * position;
        Eigen::Index face = 0;
        const double depth = (box.half - inside.cwiseAbs()).minCoeff(&face);
        if (depth > 0) {
            const Eigen::Vector3d axis = box.T_base_box.linear().col(face);
            force += push(box.material, inside[face] < 0 ? Eigen::Vector3d(-axis) : axis, depth, velocity);
        }
    }
    return force;
}

}  // namespace tiller::simulator::arm
