// SPDX-License-Identifier: MIT
#pragma once

// State enumerations of the controller, with the numbers used by RTDE. Source: RTDE guide. Only newer
// software reports the numbers above 13.

#include <QString>
#include <cstdint>

#include "robot/core/text.h"

namespace tiller {

enum class RobotMode : std::int32_t {
    NoController = -1,
    Disconnected = 0,
    ConfirmSafety = 1,
    Booting = 2,
    PowerOff = 3,
    PowerOn = 4,
    Idle = 5,
    Backdrive = 6,
    Running = 7,
    UpdatingFirmware = 8,
};

enum class SafetyMode : std::int32_t {
    Normal = 1,
    Reduced = 2,
    ProtectiveStop = 3,
    Recovery = 4,
    SafeguardStop = 5,
    SystemEmergencyStop = 6,
    RobotEmergencyStop = 7,
    Violation = 8,
    Fault = 9,
    ValidateJointId = 10,
    Undefined = 11,
    AutomaticModeSafeguardStop = 12,
    SystemThreePositionEnablingStop = 13,
    TpThreePositionEnablingStop = 14,
    ImmiEmergencyStop = 15,
    ImmiSafeguardStop = 16,
    ProfisafeWaitingForParameters = 17,
    ProfisafeAutomaticModeSafeguardStop = 18,
    ProfisafeSafeguardStop = 19,
    ProfisafeEmergencyStop = 20,
    SafetyApiSafeguardStop = 22,
};

enum class RuntimeState : std::uint32_t {
    Stopping = 0,
    Stopped = 1,
    Playing = 2,
    Pausing = 3,
    Paused = 4,
    Resuming = 5,
};

enum class JointMode : std::int32_t {
    Backdrive = 238,
    PowerOff = 239,
    Booting = 247,
    Running = 253,
    Idle = 255,
};

/// Name as spelled by the controller, e.g. "POWER_OFF". Unknown numbers return "UNKNOWN_<n>".
QString robotModeName(RobotMode mode);
QString safetyModeName(SafetyMode mode);       ///< e.g. "PROTECTIVE_STOP"
QString runtimeStateName(RuntimeState state);  ///< e.g. "PLAYING"
QString jointModeName(JointMode mode);         ///< e.g. "RUNNING"
inline std::ostream& operator<<(std::ostream& out, RobotMode mode) {
    return out << robotModeName(mode).toStdString();
}
inline std::ostream& operator<<(std::ostream& out, SafetyMode mode) {
    return out << safetyModeName(mode).toStdString();
}
inline std::ostream& operator<<(std::ostream& out, RuntimeState state) {
    return out << runtimeStateName(state).toStdString();
}
inline std::ostream& operator<<(std::ostream& out, JointMode mode) {
    return out << jointModeName(mode).toStdString();
}

/// True for the two safety modes in which the arm may move.
inline bool allowsMotion(SafetyMode mode) {
    return mode == SafetyMode::Normal || mode == SafetyMode::Reduced;
}

}  // namespace tiller
