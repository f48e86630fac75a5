// SPDX-License-Identifier: MIT
#pragma once

// The arm giving way: to a force it shall keep up, to the hand, to what it touches.

#include <array>
#include <cstdint>
#include <optional>

#include "robot/control/controller.h"
#include "robot/control/motion.h"
#include "robot/core/spatial.h"

namespace tiller::control {

struct ForceMode {
    /// How the force frame follows from the task frame. Source: URScript force_mode
    enum class Type : std::uint8_t {
        PointToOrigin = 1,  ///< y points from the TCP to the task frame's origin
        Simple = 2,         ///< the task frame as it is
        Motion = 3,         ///< x is the TCP's velocity projected on the task frame's x-y plane
    };
    Pose taskFrame;                   ///< base frame
    std::array<bool, 6> compliant{};  ///< per axis of the force frame
    Wrench wrench;                    ///< wanted on the compliant axes [N, Nm]
    Type type = Type::Simple;
    /// Compliant axes: highest speed [m/s, rad/s]; others: largest deviation [m, rad]. All > 0
    std::array<double, 6> limits{};
};

enum class AfterContact : std::uint8_t {
    Stand,   ///< stops
    Return,  ///< stops, then goes back to where the contact began
};

struct Freedrive {
    std::array<bool, 6> freeAxes{true, true, true, true, true, true};
    /// The axes' frame, in the base frame. Source: URScript freedrive_mode. Without axes and frame on
    /// software before 5.10
    Pose feature;
};

/// Errors   of every call: NotInControl, UnsafeState, LinkLost, Timeout, Cancelled, InvalidArgument,
///          VersionUnsupported
/// Threads  any. Blocks: until the robot confirmed, at most until the deadline
class Compliance {
public:
    explicit Compliance(Controller& controller) : controller_(&controller) {}
    /// As Motions(controller, stops): setForceMode() begins nothing once there has been a stop since Controller::stops()
    /// was this (Stopped).
    Compliance(Controller& controller, std::uint64_t stops) : controller_(&controller), stops_(stops) {}

    /// Begins or changes force mode; it lasts until endForceMode(), a stop of the controller, or 100 ms
    /// without link. Motions may run meanwhile.
    Result<void> setForceMode(const ForceMode& mode, const Deadline& deadline);
    Result<void> endForceMode(const Deadline& deadline);  ///< The arm is stiff again.
    /// 0 ... 1. Since 3.5
    Result<void> setForceDamping(double damping, const Deadline& deadline);
    /// 0 ... 2. Since 5.0
    Result<void> setForceGainScaling(double scaling, const Deadline& deadline);

    /// The arm follows the hand until the motion is cancelled, or, when held, not refreshed for 100 ms
    /// (Motion::refresh).
    Result<Motion> startFreedrive(const Freedrive& freedrive = {}, Holding holding = Holding::Free);
    /// Freedrive on all axes, as software of every age knows it. Source: URScript teach_mode
    Result<Motion> startTeachMode(Holding holding = Holding::Free);

    /// Looks for contact from now on; the motion under way then ends with StopCause::Contact. What touches
    /// already is none.
    /// direction  base frame; zeros: the direction the tool moves in. Since 5.4
    /// after      what the arm does then; it is part of the motion, and any stop ends it
    Result<void> startContactDetection(const Twist& direction, const Deadline& deadline,
                                       AfterContact after = AfterContact::Stand);
    Result<bool> hasContact(const Deadline& deadline);  ///< Since the watch began.
    /// Returns  whether there was contact
    Result<bool> endContactDetection(const Deadline& deadline);

private:
    Controller* controller_;
    std::optional<std::uint64_t> stops_;
};

}  // namespace tiller::control
