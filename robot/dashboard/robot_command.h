// SPDX-License-Identifier: MIT
#pragma once

#include "robot/core/text.h"

// Names of the controller commands other than motion, and of the services that execute them. robot_service.h
// executes the commands.

namespace tiller::dashboard {

using tiller::operator<<;  // makes the enumerations below printable

enum class ServiceKind {
    Unknown,    ///< not determined yet, or no response
    Dashboard,  ///< CB3 and e-Series
    RobotApi,   ///< PolyScope X
};

enum class RobotCommand {
    PowerOn,
    ReleaseBrakes,
    PowerOff,
    RestartSafety,  ///< after a violation or fault; the arm remains powered off
    ClosePopups,    ///< both the ordinary popup and the safety popup on the teach pendant
    Play,           ///< starts or resumes the loaded program
    Pause,
    StopProgram,
};

/// True if a service of this kind supports the command. For example, the Robot API cannot close popups.
inline bool offers(ServiceKind kind, RobotCommand command) {
    return kind != ServiceKind::RobotApi || command != RobotCommand::ClosePopups;
}

}  // namespace tiller::dashboard
