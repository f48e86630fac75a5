// SPDX-License-Identifier: MIT
#pragma once

// Values exchanged between the controller and control.script through RTDE registers, and their RTDE fields.
// The numbers are the same as in control.script.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robot/control/controller.h"
#include "robot/rtde/recipe.h"

namespace tiller::receive {
struct Sample;
}

namespace tiller::control {

int firstRegister(RegisterRange range);     ///< 0 or 24
inline constexpr int kEpochRegister = 1;    ///< integer input, relative to the first register
inline constexpr int kChoiceRegister = 3;   ///< integer input, relative to the first register
inline constexpr int kSessionRegister = 4;  ///< integer input, relative to the first register
inline constexpr int kWholeRegister = 7;    ///< integer input, relative to the first register
inline constexpr int kStateRegister = 2;    ///< integer output, relative to the first register

enum class ScriptCommand : std::int32_t {
    Idle = 0,  ///< no motion; ends the active motion
    JogCartesian = 1,
    JogJoints = 2,
    MoveJ = 3,
    MoveL = 4,
    MoveJToPose = 5,
    MoveLToJoints = 6,
    Section = 7,  ///< path or function sent with the program
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
    Ready = 0,      ///< at standstill without a command
    Executing = 1,  ///< executing the command of the echoed epoch
    Done = 2,       ///< the move of the echoed epoch has reached its target
    Braking = 3,
    /// No new sequence number for 100 ms: the arm has stopped, and the echoed epoch is invalid. A negative
    /// register value has the same meaning; see AbandonedProgram.
    Expired = 4,
    OutOfReach = 5,  ///< no joint positions for the target; stopped, epoch invalid
    Contact = 6,     ///< contact detected; stopped, epoch invalid
    TooFar = 7,      ///< servo target too far away; stopped, epoch invalid
    TcpTooFast = 8,  ///< TCP above the cap with torques; stopped, epoch invalid
    ElbowTooFast = 9,
    /// Set by a user program that replaced the control program and ended without a heartbeat.
    HeartbeatExpired = 100'004,
};

/// Queries and settings. Source: serve() in control.script
enum class RequestKind : std::int32_t {
    None = 0,
    Store = 1,  ///< stores six numbers for a later request; `whole`: offset 0 or 6 of the twelve
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

/// A request that every package to the control program contains until the request is answered.
struct Request {
    std::int32_t number = 0;  ///< unique number of each request
    RequestKind kind = RequestKind::None;
    std::int32_t whole = 0;
    std::array<double, 6> numbers{};
};

enum class Outcome : std::int32_t { Done = 0, NoSolution = 1, Unknown = 2, NotPermitted = 3 };

struct Answer {
    std::int32_t number = 0;  ///< number of the answered request
    Outcome outcome = Outcome::Done;
    std::int32_t whole = 0;
    std::array<double, 6> numbers{};
};

/// Sequence numbers exceed this value. Programs written for ur_rtde keep 1 or 2 in the register that echoes
/// the sequence number, so the running program can be identified without a query.
inline constexpr std::int32_t kBeforeFirstSequence = 0x1000;

/// One package to the robot.
struct Command {
    std::int32_t sequence = 0;  ///< changes with every package: the heartbeat
    std::int32_t epoch = 0;
    ScriptCommand kind = ScriptCommand::Idle;
    /// Jogs: a JogFrame. User programs: script::StepGate::value(). Other commands: see control.script.
    std::int32_t choice = 0;
    std::int32_t session = 0;  ///< identifies the instance of the program
    /// Twist, joint speeds, torques or target pose/positions. User programs: a script::VariableChange.
    std::array<double, 6> values{};
    double speed = 0;                  ///< moves only
    double acceleration = 0;           ///< [m/s2] or [rad/s2]
    double rotationAcceleration = 0;   ///< [rad/s2]
    std::array<double, 3> rotation{};  ///< JogFrame::Custom: rotation vector of the frame
    Request request;
    bool forcePermitted = false;          ///< force mode is permitted
    double speedFraction = 1;             ///< speed slider value
    bool mayFinish = false;               ///< a move or path may complete without a heartbeat
    std::int32_t heartbeatTimeoutMs = 0;  ///< maximum time of a move or path without a heartbeat; 0: default
};

/// Values of control.script in its output registers.
struct Echo {
    std::int32_t sequence = 0;
    std::int32_t epoch = 0;
    ScriptState state = ScriptState::Ready;
    std::int32_t session = 0;
    std::int32_t waypoint = 0;  ///< path: current target, counted from 1
    Answer answer;
};

/// The values from a robot packet that the control thread needs.
struct Feedback {
    std::int64_t hostNs = 0;
    bool awaited = true;  ///< true: hostNs is the arrival time; false: the packet may have arrived earlier
    std::int64_t lookedNs = 0;  ///< if not awaited: time of the previous check of the connection
    double timestamp = 0;       ///< controller time [s]
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
    std::optional<Eigen::Vector3d> tcpForce;  ///< force at the TCP in the base frame [N]
    Echo echo;
    /// All values of the packet; null before control is taken. Valid until the next packet is read.
    const receive::Sample* sample = nullptr;
};

/// extra  additional outputs to receive; duplicates are ignored
std::vector<std::string> outputNames(RegisterRange range, const std::vector<std::string>& extra = {});
/// Recipes of the control connection, in the order in which they are set up.
enum Inputs : std::size_t { kCommandInputs, kWatchdogInputs, kWrenchInputs, kInputRecipes };
std::vector<std::string> inputNames(RegisterRange range, Inputs recipe = kCommandInputs);
std::string watchdogName(RegisterRange range);

/// Resolves the values of a recipe once, so that decoding a packet only copies values.
class FeedbackLayout {
public:
    /// Errors   FieldUnknown with the required outputs that this robot lacks
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
