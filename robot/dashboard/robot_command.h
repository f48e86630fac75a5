// SPDX-License-Identifier: MIT
#pragma once

#include "robot/core/text.h"

// What can be asked of the controller itself, apart from motion, and which way it takes. Names only: what
// carries them out is robot_service.h.

namespace tiller::dashboard {

using tiller::operator<<;  // for the enumerations below

enum class ServiceKind {
    Unknown,    ///< not asked yet, or nobody answers
    Dashboard,  ///< CB3 and e-Series
    RobotApi,   ///< PolyScope X
};

enum class RobotCommand {
    PowerOn,
    ReleaseBrakes,
    PowerOff,
    RestartSafety,  ///< after a violation or a fault; leaves the arm powered off
    ClosePopups,    ///< the ordinary popup and the safety popup on the pendant
    Play,           ///< starts or resumes the loaded program
    Pause,
    StopProgram,
};

/// Whether a service of this kind has the command at all: the Robot API closes no popups.
inline bool offers(ServiceKind kind, RobotCommand command) {
    return kind != ServiceKind::RobotApi || command != RobotCommand::ClosePopups;
}

}  // namespace tiller::dashboard
