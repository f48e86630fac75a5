// SPDX-License-Identifier: MIT
#pragma once

// Names used by the dashboard server.

namespace ur_rtde {

enum class ProgramState { STOPPED, PLAYING, PAUSED };

enum class UserRole { PROGRAMMER, OPERATOR, NONE, LOCKED, RESTRICTED };

enum class SafetyMode {
    NORMAL,
    REDUCED,
    PROTECTIVE_STOP,
    RECOVERY,
    SAFEGUARD_STOP,
    SYSTEM_EMERGENCY_STOP,
    ROBOT_EMERGENCY_STOP,
    VIOLATION,
    FAULT
};

enum class SafetyStatus {
    NORMAL,
    REDUCED,
    PROTECTIVE_STOP,
    RECOVERY,
    SAFEGUARD_STOP,
    SYSTEM_EMERGENCY_STOP,
    ROBOT_EMERGENCY_STOP,
    VIOLATION,
    FAULT,
    AUTOMATIC_MODE_SAFEGUARD_STOP,
    SYSTEM_THREE_POSITION_ENABLING_STOP
};

enum class RobotMode {
    NO_CONTROLLER,
    DISCONNECTED,
    CONFIRM_SAFETY,
    BOOTING,
    POWER_OFF,
    POWER_ON,
    IDLE,
    BACKDRIVE,
    RUNNING
};

}  // namespace ur_rtde
