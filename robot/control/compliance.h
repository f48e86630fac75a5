// SPDX-License-Identifier: MIT
#pragma once

// Compliance of the arm: force mode, freedrive and contact detection.

#include <array>
#include <cstdint>
#include <optional>

#include "robot/control/controller.h"
#include "robot/control/motion.h"
#include "robot/core/spatial.h"

namespace tiller::control {

struct ForceMode {
    /// Definition of the force frame relative to the task frame. Source: URScript force_mode
    enum class Type : std::uint8_t {
        PointToOrigin = 1,  ///< y points from the TCP to the origin of the task frame
        Simple = 2,         ///< equal to the task frame
        Motion = 3,         ///< x is the TCP velocity projected onto the x-y plane of the task frame
    };
    Pose taskFrame;                   ///< in the base frame
    std::array<bool, 6> compliant{};  ///< true: the axis of the force frame is compliant
    Wrench wrench;                    ///< target force and torque on the compliant axes [N, Nm]
    Type type = Type::Simple;
    /// Compliant axes: maximum speed [m/s, rad/s]. Other axes: maximum deviation [m, rad]. All values must be
    /// above 0.
    std::array<double, 6> limits{};
};

enum class AfterContact : std::uint8_t {
    Stand,   ///< stop only
    Return,  ///< stop, then return to the pose of the first contact
};

struct Freedrive {
    std::array<bool, 6> freeAxes{true, true, true, true, true, true};
    /// Frame of the axes, relative to the base frame. Software before 5.10 ignores the axes and the frame.
    /// Source: URScript freedrive_mode
    Pose feature;
};

/// Errors   of every call: NotInControl, UnsafeState, LinkLost, Timeout, Cancelled, InvalidArgument,
///          VersionUnsupported
/// Threads  any. Blocks: until confirmed by the robot, at most until the deadline
class Compliance {
public:
    explicit Compliance(Controller& controller) : controller_(&controller) {}
    /// As with Motions(controller, stops), setForceMode() fails with Stopped if a stop has occurred since
    /// Controller::stops() returned `stops`.
    Compliance(Controller& controller, std::uint64_t stops) : controller_(&controller), stops_(stops) {}

    /// Starts force mode or changes its parameters. Motions are possible in force mode. Force mode ends with
    /// endForceMode(), a stop of the controller, or 100 ms without connection.
    Result<void> setForceMode(const ForceMode& mode, const Deadline& deadline);
    Result<void> endForceMode(const Deadline& deadline);  ///< Ends force mode.
    /// 0 ... 1. Since 3.5
    Result<void> setForceDamping(double damping, const Deadline& deadline);
    /// 0 ... 2. Since 5.0
    Result<void> setForceGainScaling(double scaling, const Deadline& deadline);

    /// Makes the arm movable by hand until the motion is cancelled. A Held motion also ends after 100 ms
    /// without Motion::refresh().
    Result<Motion> startFreedrive(const Freedrive& freedrive = {}, Holding holding = Holding::Free);
    /// Freedrive on all axes, supported by all software versions. Source: URScript teach_mode
    Result<Motion> startTeachMode(Holding holding = Holding::Free);

    /// Starts contact detection. A contact ends the current motion with StopCause::Contact. Contacts that
    /// already exist are ignored.
    /// direction  base frame; zeros: direction of the tool motion. Since 5.4
    /// after      reaction to the contact; it is part of the motion and ends with any stop
    Result<void> startContactDetection(const Twist& direction, const Deadline& deadline,
                                       AfterContact after = AfterContact::Stand);
    Result<bool> hasContact(const Deadline& deadline);  ///< True if a contact has occurred since the start of
                                                        ///< the detection.
    /// Returns  true if a contact occurred
    Result<bool> endContactDetection(const Deadline& deadline);

private:
    Controller* controller_;
    std::optional<std::uint64_t> stops_;
};

}  // namespace tiller::control
