// SPDX-License-Identifier: MIT
#pragma once

// Six joint values in the order base, shoulder, elbow, wrist 1, wrist 2, wrist 3. Positions, velocities,
// accelerations and torques have different types, so that they cannot be confused.

#include <Eigen/Core>
#include <array>
#include <concepts>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "robot/core/text.h"

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
    /// Errors   std::invalid_argument if the size is not 6
    template <std::same_as<std::vector<double>> List>
    explicit JointArray(const List& v) : values(Eigen::Map<const Vector6>(sixOf(v).data())) {}

    double& operator[](int joint) { return values[joint]; }
    double operator[](int joint) const { return values[joint]; }
    std::array<double, 6> array() const {  ///< Base to wrist 3.
        return {values[0], values[1], values[2], values[3], values[4], values[5]};
    }
    std::vector<double> toStdVector() const { return {begin(), end()}; }  ///< Base to wrist 3.
    bool allFinite() const { return values.allFinite(); }  ///< True if no value is NaN or infinite.

    double* begin() { return values.data(); }
    double* end() { return values.data() + kJointCount; }
    const double* begin() const { return values.data(); }
    const double* end() const { return values.data() + kJointCount; }

    JointArray& operator+=(const JointArray& other) { return values += other.values, *this; }
    JointArray& operator-=(const JointArray& other) { return values -= other.values, *this; }
    JointArray& operator*=(double factor) { return values *= factor, *this; }
    friend JointArray operator+(JointArray a, const JointArray& b) { return a += b; }
    friend JointArray operator-(JointArray a, const JointArray& b) { return a -= b; }
    friend JointArray operator-(const JointArray& a) { return a * -1.0; }
    friend JointArray operator*(JointArray a, double factor) { return a *= factor; }
    friend JointArray operator*(double factor, JointArray a) { return a *= factor; }
    friend bool operator==(const JointArray& a, const JointArray& b) { return a.values == b.values; }
    friend std::ostream& operator<<(std::ostream& out, const JointArray& a) {
        return writeNumbers(out, {a.begin(), a.end()});
    }

private:
    static const std::vector<double>& sixOf(const std::vector<double>& v) {
        if (v.size() != kJointCount) {
            throw std::invalid_argument("six joint values are needed, not " + std::to_string(v.size()));
        }
        return v;
    }
};

using JointPositions = JointArray<struct JointPositionQuantity>;          ///< q [rad]
using JointVelocities = JointArray<struct JointVelocityQuantity>;         ///< qd [rad/s]
using JointAccelerations = JointArray<struct JointAccelerationQuantity>;  ///< qdd [rad/s2]
using JointTorques = JointArray<struct JointTorqueQuantity>;              ///< [Nm]

/// Names of the joints for the user interface and messages.
inline constexpr std::array<const char*, 6> kJointNames = {"Base",    "Shoulder", "Elbow",
                                                           "Wrist 1", "Wrist 2",  "Wrist 3"};

}  // namespace tiller
