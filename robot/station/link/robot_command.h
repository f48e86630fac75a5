// SPDX-License-Identifier: MIT
#pragma once

// Requests of the operator to the controller apart from motion: power, safety, programs. A command is sent once;
// its result is shown in SessionState and by a message.

#include <QString>

#include "robot/dashboard/robot_command.h"

namespace tiller {

using dashboard::RobotCommand;

/// "Power on", as on the key that asks for it and in the log.
QString commandText(RobotCommand command);

/// The operator's explicit word that the arm has been looked at. Only the page on which that word is given
/// can make one, so that nothing else in the program can unlock a protective stop: the manufacturer forbids
/// automatic reset.
class UnlockConsent {
    friend class RecoveryPage;
    UnlockConsent() = default;
};

}  // namespace tiller
