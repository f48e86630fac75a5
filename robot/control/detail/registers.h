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

int firstRegister(RegisterRange range);     ///< 0 or 24
inline constexpr int kEpochRegister = 1;    ///< integer input, counted from the first register
inline constexpr int kSessionRegister = 4;  ///< the same
inline constexpr int kStateRegister = 2;    ///< integer output

enum class ScriptCommand : std::int32_t {
    Idle = 0,  ///< nothing may move; ends whatever does
    JogCartesian = 1,
    JogJoints = 2,
    MoveJ = 3,
    MoveL = 4,
    MoveJToPose = 5,
    MoveLToJoints = 6,
    Section = 7,  ///< the path or function sent with the program
    UntilContact = 8,
    End = 9,  ///< stop, then end the program
    ServoJ = 11,
    ServoL = 12,
    ServoC = 13,
    SpeedJ = 14,
    SpeedL = 15,
    Freedrive = 16,
    Teach = 17,
    Torque = 18,
};

enum class ScriptState : std::int32_t {
    Ready = 0,      ///< standing, nothing to do
    Executing = 1,  ///< the command of the echoed epoch
    Done = 2,       ///< the move of the echoed epoch reached its target
    Braking = 3,
    Expired = 4,     ///< no fresh sequence number for 100 ms: stopped, and the echoed epoch is dead
    OutOfReach = 5,  ///< no joint positions for the target: stopped, dead
    Contact = 6,     ///< contact detection found one: stopped, dead
    TooFar = 7,      ///< a servo target further off than the arm could get: stopped, dead
    TcpTooFast = 8,  ///< torques made the TCP faster than the cap: stopped, dead
    ElbowTooFast = 9,
    /// Of a program of the user's in place of the control program: it ended because no heartbeat came.
    HeartbeatExpired = 100'004,
};

/// Questions and settings. Source: serve() in control.script
enum class RequestKind : std::int32_t {
    None = 0,
    Store = 1,  ///< six numbers for requests to come, beside their own: `whole` 0 or 6 of twelve
    SetPayload = 2,
    SetTargetPayload = 3,
    SetTcp = 4,
    SetGravity = 5,
    ZeroForceSensor = 6,
    ExternalSensor = 7,
    ExternalSensorLegacy = 8,
    SetWatchdog = 9,
    ProtectiveStop = 10,
    ForceMode = 11,
    EndForceMode = 12,
    ForceDamping = 13,
    ForceGainScaling = 14,
    WatchContact = 15,
    ReadContact = 16,
    BeginPulses = 17,
    EndPulses = 18,
    InverseKinematics = 20,
    ForwardKinematics = 21,
    PoseIsSafe = 22,
    JointsAreSafe = 23,
    JointTorques = 24,
    IsSteady = 25,
    ToolContact = 26,
    JointHistory = 27,
    TargetWaypoint = 28,
    StepTime = 29,
    TcpOffset = 30,
    FlangePose = 31,
    FreedriveStatus = 32,
};

/// To the control program; it travels with every package until the answer to it has come.
struct Request {
    std::int32_t number = 0;  ///< another one for each
    RequestKind kind = RequestKind::None;
    std::int32_t whole = 0;
    std::array<double, 6> numbers{};
};

enum class Outcome : std::int32_t { Done = 0, NoSolution = 1, Unknown = 2, NotPermitted = 3 };

struct Answer {
    std::int32_t number = 0;  ///< of the request
    Outcome outcome = Outcome::Done;
    std::int32_t whole = 0;
    std::array<double, 6> numbers{};
};

/// Sequence numbers are above this. Programs written for ur_rtde keep 1 or 2 in the register that echoes
/// them: whose program runs can be told without asking it.
inline constexpr std::int32_t kBeforeFirstSequence = 0x1000;

/// One package to the robot.
struct Command {
    std::int32_t sequence = 0;  ///< another one each time: the heartbeat
    std::int32_t epoch = 0;
    ScriptCommand kind = ScriptCommand::Idle;
    std::int32_t choice = 0;           ///< jogs: a JogFrame; others as control.script says
    std::int32_t session = 0;          ///< tells the program's instances apart
    std::array<double, 6> values{};    ///< twist, joint speeds, torques or target
    double speed = 0;                  ///< moves only
    double acceleration = 0;           ///< [m/s2] or [rad/s2]
    double rotationAcceleration = 0;   ///< [rad/s2]
    std::array<double, 3> rotation{};  ///< JogFrame::Custom: rotation vector of the frame
    Request request;
    bool forcePermitted = false;  ///< force mode may go on
    double speedFraction = 1;     ///< of the speed slider
    bool mayFinish = false;       ///< a move or path may come to its end without a heartbeat
    std::int32_t silenceMs = 0;   ///< a move or path may last so long without one; 0: as everything else
};

/// What control.script says in its output registers.
struct Echo {
    std::int32_t sequence = 0;
    std::int32_t epoch = 0;
    ScriptState state = ScriptState::Ready;
    std::int32_t session = 0;
    std::int32_t waypoint = 0;  ///< of a path: the one headed for, from 1
    Answer answer;
};

/// One package from the robot, as far as the control thread needs it.
struct Feedback {
    std::int64_t hostNs = 0;
    bool awaited = true;        ///< hostNs is when it came; otherwise it may have been there for a while
    std::int64_t lookedNs = 0;  ///< not awaited: when the connection was looked at last before
    double timestamp = 0;       ///< the controller's [s]
    RuntimeState runtimeState = RuntimeState::Stopped;
    RobotMode robotMode = RobotMode::NoController;
    SafetyMode safetyMode = SafetyMode::Undefined;
    std::uint32_t robotStatusBits = 0;
    std::uint32_t safetyStatusBits = 0;
    double speedFraction = 1;
    double speedScaling = 1;
    JointPositions q;
    JointVelocities qd;
    Pose tcpPose;
    Twist tcpSpeed;
    Pose tcpOffset;
    std::optional<Eigen::Vector3d> tcpForce;  ///< base frame [N]
    Echo echo;
};

std::vector<std::string> outputNames(RegisterRange range);
/// The recipes of the control connection, in this order.
enum Inputs : std::size_t { kCommandInputs, kWatchdogInputs, kWrenchInputs, kInputRecipes };
std::vector<std::string> inputNames(RegisterRange range, Inputs recipe = kCommandInputs);
/// The register that kicks the watchdog.
std::string watchdogName(RegisterRange range);

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
    std::optional<std::size_t> tcpOffset_, speedScaling_, tcpForce_, robotStatus_, safetyStatus_;
    std::array<std::size_t, 8> echo_{};
    std::array<std::size_t, 6> numbers_{};
};

inline constexpr std::size_t kCommandSize = 28;
/// The values in the order of inputNames(). Real-time: yes
std::array<double, kCommandSize> encode(const Command& command);

}  // namespace tiller::control
