// SPDX-License-Identifier: MIT
#pragma once

// Requests of the operator to the controller apart from motion: power, safety, programs. A command is sent once;
// its result is shown in SessionState and by a message.

#include <QString>

#include "robot/dashboard/robot_command.h"

namespace tiller {

using dashboard::RobotCommand;

/// "Power on", the label of the button and the name in the log.
QString commandText(RobotCommand command);

/// Confirmation by the operator that the arm has been inspected. Only the page that asks for it can create
/// one, so that no other part of the program can unlock a protective stop: the manufacturer forbids automatic
/// reset.
class UnlockConsent {
    friend class RecoveryPage;
    UnlockConsent() = default;
};

}  // namespace tiller
