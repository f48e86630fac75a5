// SPDX-License-Identifier: MIT
#pragma once

// Questions only the robot can answer: with its own calibration, limits and sensors.

#include <optional>
#include <variant>

#include "robot/control/controller.h"
#include "robot/core/joints.h"
#include "robot/core/spatial.h"

namespace tiller::control {

struct InverseOptions {
    std::optional<JointPositions> near = {};  ///< the solution nearest to this; left out: to the present ones
    double maxPositionError = 1e-10;          ///< [m]
    double maxOrientationError = 1e-10;       ///< [rad]
};

/// Errors   of every call: NotInControl, LinkLost, Timeout, Cancelled, InvalidArgument, VersionUnsupported
/// Threads  any. Blocks: until the answer, some 6 ms, at most until the deadline
class ArmQueries {
public:
    explicit ArmQueries(Controller& controller) : controller_(&controller) {}

    /// Errors  also NoSolution. Source: URScript get_inverse_kin, and so below
    Result<JointPositions> inverseKinematics(const Pose& tcpPose, const InverseOptions& options,
                                             const Deadline& deadline);
    /// Whether there is one; errors as of inverseKinematics().
    Result<bool> hasInverseKinematics(const Pose& tcpPose, const InverseOptions& options,
                                      const Deadline& deadline);
    /// q, tcp   left out: the present ones
    /// Returns  the TCP's pose in the base frame
    Result<Pose> forwardKinematics(const std::optional<JointPositions>& q, const std::optional<Pose>& tcp,
                                   const Deadline& deadline);
    /// Of a TCP pose [m, rad], base frame.
    Result<bool> isWithinSafetyLimits(const Pose& tcpPose, const Deadline& deadline);
    /// Of joint positions [rad].
    Result<bool> isWithinSafetyLimits(const JointPositions& q, const Deadline& deadline);
    /// Torques without gravity and friction [Nm].
    Result<JointTorques> jointTorques(const Deadline& deadline);
    /// True when the arm has stood still for half a second.
    Result<bool> isSteady(const Deadline& deadline);
    /// Returns  how many control steps ago the contact began; 0: none. Since 5.4
    Result<int> toolContact(const Twist& direction, const Deadline& deadline);
    /// The TCP pose the present move heads for. Since 5.3
    Result<Pose> targetWaypoint(const Deadline& deadline);
    /// steps  control steps ago, 0 or more. Since 5.4
    Result<JointPositions> jointPositionsHistory(int steps, const Deadline& deadline);
    Result<double> stepTime(const Deadline& deadline);  ///< [s]
    Result<Pose> tcpOffset(const Deadline& deadline);   ///< T_flange_tcp
    Result<Pose> flangePose(const Deadline& deadline);  ///< T_base_flange
    /// 0 normal, 1 near a singularity, 2 too near one. Since 5.10
    Result<int> freedriveStatus(const Deadline& deadline);

private:
    Controller* controller_;
};

}  // namespace tiller::control
