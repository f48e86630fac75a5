// SPDX-License-Identifier: MIT
#pragma once

// Queries that the robot answers from its calibration, limits and sensors.

#include <optional>
#include <variant>

#include "robot/control/controller.h"
#include "robot/core/joints.h"
#include "robot/core/spatial.h"

namespace tiller::control {

struct InverseOptions {
    /// Reference position: the nearest solution is returned. Empty: the current joint positions.
    std::optional<JointPositions> near = {};
    double maxPositionError = 1e-10;     ///< [m]
    double maxOrientationError = 1e-10;  ///< [rad]
};

/// Errors   of every call: NotInControl, LinkLost, Timeout, Cancelled, InvalidArgument, VersionUnsupported
/// Threads  any. Blocks: until the answer, typically 6 ms, at most until the deadline
class ArmQueries {
public:
    explicit ArmQueries(Controller& controller) : controller_(&controller) {}

    /// Errors  also NoSolution
    /// Source  URScript get_inverse_kin. Each of the following functions uses the URScript function of the
    ///         same name
    Result<JointPositions> inverseKinematics(const Pose& tcpPose, const InverseOptions& options,
                                             const Deadline& deadline);
    /// True if a solution exists. Errors: same as inverseKinematics().
    Result<bool> hasInverseKinematics(const Pose& tcpPose, const InverseOptions& options,
                                      const Deadline& deadline);
    /// q, tcp   empty: the current values
    /// Returns  pose of the TCP in the base frame
    Result<Pose> forwardKinematics(const std::optional<JointPositions>& q, const std::optional<Pose>& tcp,
                                   const Deadline& deadline);
    /// Checks a TCP pose in the base frame [m, rad].
    Result<bool> isWithinSafetyLimits(const Pose& tcpPose, const Deadline& deadline);
    /// Checks joint positions [rad].
    Result<bool> isWithinSafetyLimits(const JointPositions& q, const Deadline& deadline);
    /// Joint torques without gravity and friction [Nm].
    Result<JointTorques> jointTorques(const Deadline& deadline);
    /// True if the arm has been at standstill for half a second.
    Result<bool> isSteady(const Deadline& deadline);
    /// Returns  the number of control periods since the start of the contact, 0 without contact. Since 5.4
    Result<int> toolContact(const Twist& direction, const Deadline& deadline);
    /// Target TCP pose of the current move. Since 5.3
    Result<Pose> targetWaypoint(const Deadline& deadline);
    /// steps  number of control periods in the past, 0 or more. Since 5.4
    Result<JointPositions> jointPositionsHistory(int steps, const Deadline& deadline);
    Result<double> stepTime(const Deadline& deadline);  ///< control period [s]
    Result<Pose> tcpOffset(const Deadline& deadline);   ///< T_flange_tcp
    Result<Pose> flangePose(const Deadline& deadline);  ///< T_base_flange
    /// 0: normal, 1: near a singularity, 2: too close to a singularity. Since 5.10
    Result<int> freedriveStatus(const Deadline& deadline);

private:
    Controller* controller_;
};

}  // namespace tiller::control
