// SPDX-License-Identifier: MIT
#pragma once

// Commands from the operator to the controller other than motion: power, safety, programs. A command is sent
// once. The result is logged and appears in SessionState.

#include <QString>

#include "robot/dashboard/robot_command.h"

namespace tiller {

using dashboard::RobotCommand;

/// The label of the button and the name in the log, e.g. "Power on".
QString commandText(RobotCommand command);

/// Confirmation by the operator that the arm has been inspected. Only RecoveryPage can create this object, so
/// no other part of the program can unlock a protective stop. The manufacturer forbids automatic reset.
class UnlockConsent {
    friend class RecoveryPage;
    UnlockConsent() = default;
};

}  // namespace tiller
