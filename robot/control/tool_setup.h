// SPDX-License-Identifier: MIT
#pragma once

// Robot settings for the tool, the force sensor and the environment.

#include <array>
#include <optional>

#include "robot/control/controller.h"
#include "robot/core/spatial.h"

namespace tiller::control {

struct ExternalSensor {
    double mass = 0;                                            ///< mass of the sensor [kg], 0 or more
    Eigen::Vector3d measuringOffset = Eigen::Vector3d::Zero();  ///< from the flange [m]
    Eigen::Vector3d centreOfGravity = Eigen::Vector3d::Zero();  ///< from the flange [m]
};

/// Errors   of every call: NotInControl, LinkLost, Timeout, Cancelled, InvalidArgument, LimitExceeded,
///          VersionUnsupported
/// Threads  any. Blocks: until confirmed by the robot, at most until the deadline
class ToolSetup {
public:
    explicit ToolSetup(Controller& controller) : controller_(&controller) {}

    /// mass [kg], centreOfGravity from the flange [m]; empty: unchanged. Source: URScript set_payload
    Result<void> setPayload(double mass, const std::optional<Eigen::Vector3d>& centreOfGravity,
                            const Deadline& deadline);
    /// inertia Ixx, Iyy, Izz, Ixy, Ixz, Iyz [kg m2]. Since 5.10. Source: URScript set_target_payload
    Result<void> setTargetPayload(double mass, const Eigen::Vector3d& centreOfGravity,
                                  const std::array<double, 6>& inertia, const Deadline& deadline);
    /// T_flange_tcp [m, rad]
    Result<void> setTcp(const Pose& tcp, const Deadline& deadline);
    /// direction  negative gravitational acceleration, base frame [m/s2]: (0, 0, 9.82) for an upright robot
    Result<void> setGravity(const Eigen::Vector3d& direction, const Deadline& deadline);
    Result<void> zeroForceSensor(const Deadline& deadline);  ///< Sets the current reading to zero.

    /// Uses the forces of setExternalWrench() instead of the robot's sensor. The robot pauses the program if
    /// no value arrives for 100 ms. Since 5.9 / 3.14. Source: URScript ft_rtde_input_enable
    Result<void> useExternalSensor(const ExternalSensor& sensor, const Deadline& deadline);
    /// Like useExternalSensor(), with the function of older software. The torques have the opposite sign.
    Result<void> useExternalSensorLegacy(const ExternalSensor& sensor, const Deadline& deadline);
    Result<void> useOwnSensor(const Deadline& deadline);  ///< Ends useExternalSensor().
    /// Sends one measurement with the next cycle.
    /// Errors  NotInControl, FieldUnknown, RegisterInUse, InvalidArgument. Blocks: never. Real-time: yes
    Result<void> setExternalWrench(const Wrench& wrench);

    /// Makes the robot stop the program if kickWatchdog() is called less often than this frequency [Hz].
    Result<void> setWatchdog(double minFrequency, const Deadline& deadline);
    /// Errors  NotInControl, RegisterInUse. Blocks: never. Real-time: yes
    Result<void> kickWatchdog();

    /// Triggers a protective stop. Since 3.8.
    /// Returns  ok if the robot reports the protective stop
    Result<void> triggerProtectiveStop(const Deadline& deadline);

private:
    Controller* controller_;
};

}  // namespace tiller::control
