// SPDX-License-Identifier: MIT
#pragma once

// Looks at arguments before anything is sent, and names the one that is wrong: not a number, out of its
// range, or so large that it must be degrees or millimetres.

#include "robot/control/detail/velocity_limiter.h"
#include "robot/control/motion_types.h"
#include "robot/core/error.h"

namespace tiller::control {

// Source: the limits ur_rtde and the controller agree on.
inline constexpr double kHighestToolSpeed = 3.0;           ///< [m/s]
inline constexpr double kHighestToolAcceleration = 150.0;  ///< [m/s2]
inline constexpr double kHighestBlend = 2.0;               ///< [m]

/// Keeps the first complaint. Names must be literals.
/// Real-time: yes, as long as there is nothing to complain about
class ArgumentCheck {
public:
    explicit ArgumentCheck(const char* context) : context_(context) {}

    ArgumentCheck& joints(const char* name, const JointPositions& q, const ArmLimits& arm);
    ArgumentCheck& pose(const char* name, const Pose& pose);
    ArgumentCheck& jointSpeeds(const char* name, const JointVelocities& qd, const ArmLimits& arm);
    ArgumentCheck& torques(const char* name, const JointTorques& torques, const ArmLimits& arm);
    /// cap  on the linear part [m/s]
    ArgumentCheck& twist(const char* name, const Twist& twist, double cap);
    /// A place or an offset near the robot [m].
    ArgumentCheck& offset(const char* name, const Eigen::Vector3d& metres, double largest);
    ArgumentCheck& finite(const char* name, const double* values, int count);
    /// low <= value <= high
    ArgumentCheck& range(const char* name, double value, double low, double high, const char* unit);
    /// Speed of the TCP along a line [m/s]: 0 < speed <= cap, which the caller of setSpeedCap() can raise.
    ArgumentCheck& toolSpeed(const char* name, double speed, double cap);
    /// 0 < value <= high. hint  what a far too large value may be: "deg/s"
    ArgumentCheck& positive(const char* name, double value, double high, const char* unit,
                            const char* hint = nullptr);

    bool ok() const { return error_.code == ErrorCode::None; }
    const Error& error() const { return error_; }

private:
    void refuse(ErrorCode code, const QString& message);
    bool checkFinite(const char* name, const char* part, double value);

    const char* context_;
    Error error_;
};

bool isFinite(const JogTarget& target);

/// What can only be another unit, named. kNoCap is no speed cap; there is no acceleration without a limit.
Error checkLimits(const MotionLimits& limits, const char* context);

/// The fastest joint's limit [rad/s].
double highestJointSpeed(const ArmLimits& arm);

}  // namespace tiller::control
