// SPDX-License-Identifier: MIT
#pragma once

// Environment of the arm, which is unknown to the controller: the actual load, a hand that pushes the arm,
// surfaces and boxes that the tool can touch, and moving conveyors.

#include <Eigen/Core>
#include <array>
#include <optional>

#include "robot/core/spatial.h"
#include "robot/simulator/arm/arm_state.h"

namespace tiller::simulator::arm {

/// Contact properties of a surface.
struct ContactMaterial {
    double stiffness = 20000;  ///< [N/m]
    double damping = 200;      ///< [N s/m]
    double friction = 0.2;     ///< friction coefficient, relative to the normal force
};

/// A flat surface. A TCP behind it is pushed back along the normal.
struct ContactPlane {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< [m], base frame
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< outwards; normalised when added
    ContactMaterial material = {};
};

/// A solid box; the TCP is pushed out of it through the nearest face.
struct ContactBox {
    Pose T_base_box;                                        ///< centre and axes of the box
    Eigen::Vector3d size = Eigen::Vector3d::Constant(0.1);  ///< full edge lengths along its axes [m]
    ContactMaterial material = {};
};

class Environment {
public:
    /// Sets the actual load. Empty: the actual load is the configured payload.
    void setLoad(const std::optional<Payload>& load) { load_ = load; }
    const std::optional<Payload>& load() const { return load_; }  ///< Empty: the configured payload.

    /// Sets the force and torque that a hand exerts at the TCP, base axes [N, Nm]. Constant until changed.
    void setHandWrench(const Wrench& wrench) { hand_ = wrench; }
    const Wrench& handWrench() const { return hand_; }  ///< [N, Nm] at the TCP, base frame

    /// Adds a surface. Returns false if kMaxPlanes exist or the plane is invalid.
    bool addPlane(const ContactPlane& plane);
    /// Adds a box. Returns false if kMaxBoxes exist or the box is invalid.
    bool addBox(const ContactBox& box);
    void clearSurfaces() { planeCount_ = boxCount_ = 0; }  ///< Removes planes and boxes.

    /// Sets the speed of the conveyor with this encoder (0 or 1) [ticks/s]. NaN is ignored.
    void setConveyorSpeed(int encoder, double ticksPerSecond);
    const std::array<double, 2>& conveyorSpeeds() const { return conveyorSpeeds_; }  ///< [ticks/s]

    /// Contact force that triggers a protective stop [N].
    static constexpr double kForceLimit = 250;

    /// Force of surfaces and boxes on a TCP at `position` with `velocity`, base axes [N]. They exert no
    /// torque about the TCP.
    Eigen::Vector3d contactForce(const Eigen::Vector3d& position, const Eigen::Vector3d& velocity) const;

    static constexpr int kMaxPlanes = 8;
    static constexpr int kMaxBoxes = 8;

private:
    struct Box {
        Eigen::Isometry3d T_base_box = Eigen::Isometry3d::Identity();
        Eigen::Vector3d half = Eigen::Vector3d::Zero();
        ContactMaterial material = {};
    };

    std::optional<Payload> load_;
    Wrench hand_;
    std::array<ContactPlane, kMaxPlanes> planes_{};
    std::array<Box, kMaxBoxes> boxes_{};
    std::array<double, 2> conveyorSpeeds_{};
    int planeCount_ = 0;
    int boxCount_ = 0;
};

}  // namespace tiller::simulator::arm
