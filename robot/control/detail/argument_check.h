// SPDX-License-Identifier: MIT
#pragma once

// Checks arguments before they are sent. Reports invalid values: NaN, out of range, or so large that they are
// probably in degrees or millimetres.

#include "robot/control/detail/velocity_limiter.h"
#include "robot/control/motion_types.h"
#include "robot/core/error.h"

namespace tiller::control {

// Limits used by ur_rtde and the controller.
inline constexpr double kHighestToolSpeed = 3.0;           ///< [m/s]
inline constexpr double kHighestToolAcceleration = 150.0;  ///< [m/s2]
inline constexpr double kHighestBlend = 2.0;               ///< [m]

/// Keeps only the first error. Names must be string literals. Real-time: yes, unless there is an error
class ArgumentCheck {
public:
    explicit ArgumentCheck(const char* context) : context_(context) {}

    ArgumentCheck& joints(const char* name, const JointPositions& q, const ArmLimits& arm);
    ArgumentCheck& pose(const char* name, const Pose& pose);
    ArgumentCheck& jointSpeeds(const char* name, const JointVelocities& qd, const ArmLimits& arm);
    ArgumentCheck& torques(const char* name, const JointTorques& torques, const ArmLimits& arm);
    /// cap  maximum of the linear speed [m/s]
    ArgumentCheck& twist(const char* name, const Twist& twist, double cap);
    /// Checks a position or offset near the robot [m].
    ArgumentCheck& offset(const char* name, const Eigen::Vector3d& metres, double largest);
    ArgumentCheck& finite(const char* name, const double* values, int count);
    /// Checks that low <= value <= high.
    ArgumentCheck& range(const char* name, double value, double low, double high, const char* unit);
    /// Checks a linear TCP speed [m/s]: 0 < speed <= cap. The cap is set by setSpeedCap().
    ArgumentCheck& toolSpeed(const char* name, double speed, double cap);
    /// Checks that 0 < value <= high.
    /// hint  probable unit of a value that is far too large, e.g. "deg/s"
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

/// Detects values in a wrong unit. Speeds may be kNoCap. Accelerations must be limited.
Error checkLimits(const MotionLimits& limits, const char* context);

/// Speed limit of the fastest joint [rad/s].
double highestJointSpeed(const ArmLimits& arm);

}  // namespace tiller::control
