// SPDX-License-Identifier: MIT
#pragma once

// Interface between RTDEControlInterface and the implementations of its commands: Tiller's control program
// (NativeControl), or a user program with ur_rtde's registers (custom/). Private to robot/ur_rtde.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/control/motion_types.h"
#include "robot/core/version.h"
#include "robot/ur_rtde/rtde_control_interface.h"

namespace tiller::urrtde {

/// Command numbers used by programs written for ur_rtde.
enum class CommandId : int {
    MoveJ = 1,
    MoveJIk = 2,
    MoveL = 3,
    MoveLFk = 4,
    ForceMode = 6,
    ForceModeStop = 7,
    ZeroFtSensor = 8,
    SpeedJ = 9,
    SpeedL = 10,
    ServoJ = 11,
    ServoC = 12,
    SpeedStop = 15,
    ServoStop = 16,
    SetPayload = 17,
    TeachMode = 18,
    EndTeachMode = 19,
    ForceModeDamping = 20,
    ForceModeGainScaling = 21,
    ServoL = 24,
    ToolContact = 25,
    StepTime = 26,
    JointPositionsHistory = 27,
    TargetWaypoint = 28,
    SetTcp = 29,
    InverseKinematicsNear = 30,
    ProtectiveStop = 31,
    StopL = 33,
    StopJ = 34,
    SetWatchdog = 35,
    PoseWithinLimits = 36,
    JointsWithinLimits = 37,
    JointTorques = 38,
    PoseTrans = 39,
    TcpOffset = 40,
    JogStart = 41,
    JogStop = 42,
    ForwardKinematics = 43,
    ForwardKinematicsOf = 44,
    MovePath = 45,
    InverseKinematics = 46,
    IsSteady = 47,
    MoveUntilContact = 51,
    FreedriveMode = 52,
    EndFreedriveMode = 53,
    FreedriveStatus = 54,
    ExternalForceTorque = 55,
    FtRtdeInput = 56,
    ExternalFtSensor = 57,
    ToolFlangePose = 58,
    SetGravity = 59,
    HasSolution = 60,
    HasSolutionNear = 61,
    StartContactDetection = 62,
    StopContactDetection = 63,
    ReadContactDetection = 64,
    StopScript = 255,
};

/// The register values of a command, as in ur_rtde.
struct RecipeCommand {
    CommandId id;
    int recipe;                  ///< number of the register layout in ur_rtde, 1 ... 20
    std::vector<double> values;  ///< in register order, without the command register
};

/// Reply to a command.
struct CommandResult {
    int result = 0;  ///< content of the result register; 0: not possible
    std::array<double, 6> values{};
};

/// Threads  any; commands are serialized, stops are not
class ControlBackend {
public:
    virtual ~ControlBackend() = default;

    /// Ends the active motion. The program keeps running. Unattended: moves and paths continue to their
    /// target.
    virtual void disconnect(control::Supervision supervision) = 0;
    virtual bool isConnected() const = 0;
    virtual SoftwareVersion version() const = 0;
    virtual control::JointLimits jointLimits() const = 0;
    virtual std::uint32_t robotStatus() const = 0;
    virtual int progress() const = 0;  ///< see AsyncOperationStatus
    /// Reason for the last failure; empty if unknown.
    virtual std::string lastError() const = 0;

    /// Executes a command and waits for its completion.
    /// Returns  empty if the command failed or another thread stopped it
    virtual std::optional<CommandResult> perform(const RecipeCommand& command) = 0;
    /// Sends the command at once and cancels the wait of another thread.
    /// wait  false: return after sending
    virtual bool stop(const RecipeCommand& command, bool wait = true) = 0;
    /// Sends one setpoint of a stream.
    virtual bool stream(const RecipeCommand& command) = 0;
    virtual bool follow(const ur_rtde::Path& path, bool asynchronous) = 0;
    virtual bool kickWatchdog() = 0;
    virtual bool protectiveStop() = 0;

    virtual bool reupload() = 0;
    virtual void stopProgram() = 0;
    /// Runs a user program, then restarts the control program.
    virtual bool runCustom(const std::string& program, control::Supervision supervision) = 0;
};

}  // namespace tiller::urrtde
