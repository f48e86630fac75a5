// SPDX-License-Identifier: MIT
#pragma once

// What the arm meets that the controller does not know: the load it really carries, a hand that pushes it,
// flat surfaces the tool can touch.

#include <Eigen/Core>
#include <array>
#include <optional>

#include "robot/core/spatial.h"
#include "robot/simulator/arm/arm_state.h"

namespace tiller::simulator::arm {

/// A flat surface; the TCP cannot go behind it without being pushed back along the normal.
struct ContactPlane {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< [m], base frame
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< outwards; normalised when added
    double stiffness = 20000;                           ///< [N/m]
    double damping = 200;                               ///< [N s/m]
    double friction = 0.2;                              ///< of the normal force, against sliding
};

class Environment {
public:
    /// The load really carried; nothing = exactly the configured payload.
    void setLoad(const std::optional<Payload>& load) { load_ = load; }
    const std::optional<Payload>& load() const { return load_; }

    /// What a hand exerts at the TCP, base axes [N, Nm]; stays until changed.
    void setHandWrench(const Wrench& wrench) { hand_ = wrench; }
    const Wrench& handWrench() const { return hand_; }

    /// Adds a surface; false when kMaxPlanes exist or the plane makes no sense.
    bool addPlane(const ContactPlane& plane);
    void clearPlanes() { planeCount_ = 0; }

    /// Force above which contact is a protective stop [N].
    void setForceLimit(double force) { forceLimit_ = force; }
    double forceLimit() const { return forceLimit_; }

    /// What the surfaces exert at a TCP at `position` with `velocity`, base axes [N]; no torque about the
    /// TCP.
    Eigen::Vector3d contactForce(const Eigen::Vector3d& position, const Eigen::Vector3d& velocity) const;

    static constexpr int kMaxPlanes = 8;

private:
    std::optional<Payload> load_;
    Wrench hand_;
    std::array<ContactPlane, kMaxPlanes> planes_{};
    int planeCount_ = 0;
    double forceLimit_ = 250;
};

}  // namespace tiller::simulator::arm
