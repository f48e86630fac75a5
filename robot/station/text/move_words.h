// SPDX-License-Identifier: MIT
#pragma once

// Why a move ends before its end, as a sentence, and the names of the arm's parts.

#include <QString>

#include "robot/collision/move_check.h"
#include "robot/control/control_status.h"

namespace tiller {

/// "Forearm meets “crate” after 62 % of the path".
/// Threads  any
QString limitText(const collision::MoveLimit& limit, const collision::Surroundings& surroundings);

/// "“crate”", "the floor": a number of the surroundings, as collision::Contact::other.
QString surroundingsText(collision::Contact::With with, int other,
                         const collision::Surroundings& surroundings);

/// Why the object cannot be checked, with the corrective actions; without the final period.
QString unplacedText(const collision::UnplacedObject& object);

/// The same for what slows a jog down: "Upper arm", "“crate”".
QString limiterText(const control::Limiter& limiter, const collision::Surroundings& surroundings);

/// "Forearm"; the tool for collision::kToolLink.
QString linkText(int link);

}  // namespace tiller
