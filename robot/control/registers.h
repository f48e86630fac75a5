// SPDX-License-Identifier: MIT
#pragma once

// What passes between the controller and control.script through RTDE registers, and which field each value
// travels in. The numbers here are the ones in control.script.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robot/control/controller.h"
#include "robot/rtde/recipe.h"

namespace tiller::control {

int firstRegister(RegisterRange range);  ///< 0 or 24

enum class ScriptCommand : std::int32_t {
    Idle = 0,  ///< nothing may move; ends whatever does
    JogCartesian = 1,
    JogJoints = 2,
    MoveJ = 3,
    MoveL = 4,
    End = 9,  ///< stop, then end the program
};

enum class ScriptState : std::int32_t {
    Ready = 0,      ///< standing, nothing to do
    Executing = 1,  ///< the command of the echoed epoch
    Done = 2,       ///< the move of the echoed epoch reached its target
    Braking = 3,
    Expired = 4,  ///< no fresh sequence number for 100 ms: stopped, and the echoed epoch is dead
};

/// One package to the robot.
struct Command {
    std::int32_t sequence = 0;  ///< another one each time: the heartbeat
    std::int32_t epoch = 0;
    ScriptCommand kind = ScriptCommand::Idle;
    JogFrame frame = JogFrame::Base;
    std::int32_t session = 0;          ///< tells the program's instances apart
    std::array<double, 6> values{};    ///< twist, joint speeds or target
    double speed = 0;                  ///< moves only
    double acceleration = 0;           ///< [m/s2] or [rad/s2]
    double rotationAcceleration = 0;   ///< JogCartesian [rad/s2]
    std::array<double, 3> rotation{};  ///< JogFrame::Custom: rotation vector of the frame
};

/// What control.script says in its output registers.
struct Echo {
    std::int32_t sequence = 0;
    std::int32_t epoch = 0;
    ScriptState state = ScriptState::Ready;
    std::int32_t session = 0;
};

/// One package from the robot, as far as the control thread needs it.
struct Feedback {
    std::int64_t hostNs = 0;
    double timestamp = 0;  ///< the controller's [s]
    RuntimeState runtimeState = RuntimeState::Stopped;
    RobotMode robotMode = RobotMode::NoController;
    SafetyMode safetyMode = SafetyMode::Undefined;
    double speedFraction = 1;
    JointPositions q;
    JointVelocities qd;
    Pose tcpPose;
    Twist tcpSpeed;
    Pose tcpOffset;
    Echo echo;
};

std::vector<std::string> outputNames(RegisterRange range);
std::vector<std::string> inputNames(RegisterRange range);

/// Finds the values of a recipe once, so that decoding is copying.
class FeedbackLayout {
public:
    /// Errors   FieldUnknown naming the outputs this robot lacks and control cannot do without
    static Result<FeedbackLayout> of(const rtde::Recipe& outputs, RegisterRange range);
    /// Real-time: yes
    Feedback decode(std::span<const double> values, std::int64_t hostNs) const;

private:
    std::size_t timestamp_ = 0, runtimeState_ = 0, robotMode_ = 0, safetyMode_ = 0, speedFraction_ = 0;
    std::size_t q_ = 0, qd_ = 0, tcpPose_ = 0, tcpSpeed_ = 0;
    std::optional<std::size_t> tcpOffset_;
    std::array<std::size_t, 4> echo_{};
};

inline constexpr std::size_t kCommandSize = 17;
/// The values in the order of inputNames(). Real-time: yes
std::array<double, kCommandSize> encode(const Command& command);

}  // namespace tiller::control
