// SPDX-License-Identifier: MIT
#pragma once

// Sentences for the reason why a move is cut short, and the names of the arm's parts.

#include <QString>

#include "robot/collision/move_check.h"
#include "robot/control/control_status.h"

namespace tiller {

/// "Forearm collides with “crate” after 62 % of the path".
/// Threads  any
QString limitText(const collision::MoveLimit& limit, const collision::Surroundings& surroundings);

/// "“crate”", "the floor": name of the object with this index in the cell, as in collision::Contact::other.
QString surroundingsText(collision::Contact::With with, int other,
                         const collision::Surroundings& surroundings);

/// Why the object cannot be checked, with the corrective actions; without the final period.
QString unplacedText(const collision::UnplacedObject& object);

/// As above, for the cause of a slowed-down jog: "Upper arm", "“crate”".
QString limiterText(const control::Limiter& limiter, const collision::Surroundings& surroundings);

/// "Forearm"; the tool for collision::kToolLink.
QString linkText(int link);

}  // namespace tiller
