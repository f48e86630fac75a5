// SPDX-License-Identifier: MIT
#pragma once

// What the robot has to know about its tool, its sensor and its surroundings.

#include <array>
#include <optional>

#include "robot/control/controller.h"
#include "robot/core/spatial.h"

namespace tiller::control {

struct ExternalSensor {
    double mass = 0;                                            ///< of the sensor [kg], 0 or more
    Eigen::Vector3d measuringOffset = Eigen::Vector3d::Zero();  ///< from the flange [m]
    Eigen::Vector3d centreOfGravity = Eigen::Vector3d::Zero();  ///< from the flange [m]
};

/// Errors   of every call: NotInControl, LinkLost, Timeout, Cancelled, InvalidArgument, LimitExceeded,
///          VersionUnsupported
/// Threads  any. Blocks: until the robot confirmed, at most until the deadline
class ToolSetup {
public:
    explicit ToolSetup(Controller& controller) : controller_(&controller) {}

    /// mass [kg], centreOfGravity from the flange [m]; left out: as it is. Source: URScript set_payload
    Result<void> setPayload(double mass, const std::optional<Eigen::Vector3d>& centreOfGravity,
                            const Deadline& deadline);
    /// inertia Ixx, Iyy, Izz, Ixy, Ixz, Iyz [kg m2]. Since 5.10. Source: URScript set_target_payload
    Result<void> setTargetPayload(double mass, const Eigen::Vector3d& centreOfGravity,
                                  const std::array<double, 6>& inertia, const Deadline& deadline);
    /// T_flange_tcp [m, rad]
    Result<void> setTcp(const Pose& tcp, const Deadline& deadline);
    /// direction  of the acceleration that holds the arm against gravity, base frame [m/s2]: (0, 0, 9.82) for
    ///            an upright robot
    Result<void> setGravity(const Eigen::Vector3d& direction, const Deadline& deadline);
    Result<void> zeroForceSensor(const Deadline& deadline);  ///< What it feels now becomes zero.

    /// Takes forces from setExternalWrench() in place of the robot's own sensor. The robot pauses the program
    /// when none comes for 100 ms. Since 5.9 / 3.14. Source: URScript ft_rtde_input_enable
    Result<void> useExternalSensor(const ExternalSensor& sensor, const Deadline& deadline);
    /// The same by the name older software knows (torques with the opposite sign).
    Result<void> useExternalSensorLegacy(const ExternalSensor& sensor, const Deadline& deadline);
    Result<void> useOwnSensor(const Deadline& deadline);  ///< Ends useExternalSensor().
    /// One measurement, sent with the next cycle.
    /// Errors  NotInControl, FieldUnknown, RegisterInUse, InvalidArgument. Blocks: never. Real-time: yes
    Result<void> setExternalWrench(const Wrench& wrench);

    /// From now on the program is stopped when kickWatchdog() is not called at least so often [Hz].
    Result<void> setWatchdog(double minFrequency, const Deadline& deadline);
    /// Errors  NotInControl, RegisterInUse. Blocks: never. Real-time: yes
    Result<void> kickWatchdog();

    /// Since 3.8.
    /// Returns  ok when the robot reports the protective stop
    Result<void> triggerProtectiveStop(const Deadline& deadline);

private:
    Controller* controller_;
};

}  // namespace tiller::control
