// SPDX-License-Identifier: MIT
#pragma once

// Six numbers, one a joint, in the order base, shoulder, elbow, wrist 1, wrist 2, wrist 3.
// Positions, velocities and torques are different types, so that one cannot be passed for another.

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace tiller {

inline constexpr int kJointCount = 6;

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

template <class Quantity>
struct JointArray {
    Vector6 values = Vector6::Zero();

    JointArray() = default;
    explicit JointArray(const Vector6& v) : values(v) {}
    JointArray(double base, double shoulder, double elbow, double wrist1, double wrist2, double wrist3) {
        values << base, shoulder, elbow, wrist1, wrist2, wrist3;
    }
    explicit JointArray(const std::array<double, 6>& v) : values(Eigen::Map<const Vector6>(v.data())) {}

    double& operator[](int joint) { return values[joint]; }
    double operator[](int joint) const { return values[joint]; }
    std::array<double, 6> array() const {
        return {values[0], values[1], values[2], values[3], values[4], values[5]};
    }
    bool allFinite() const { return values.allFinite(); }
    friend bool operator==(const JointArray& a, const JointArray& b) { return a.values == b.values; }
};

using JointPositions = JointArray<struct JointPositionQuantity>;          ///< q [rad]
using JointVelocities = JointArray<struct JointVelocityQuantity>;         ///< qd [rad/s]
using JointAccelerations = JointArray<struct JointAccelerationQuantity>;  ///< qdd [rad/s2]
using JointTorques = JointArray<struct JointTorqueQuantity>;              ///< [Nm]

/// Names an operator knows, for screens and messages: "Base" ... "Wrist 3".
inline constexpr std::array<const char*, 6> kJointNames = {"Base",    "Shoulder", "Elbow",
                                                           "Wrist 1", "Wrist 2",  "Wrist 3"};

}  // namespace tiller
