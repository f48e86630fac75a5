// SPDX-License-Identifier: MIT
#pragma once

// Texts that explain why a move ends early, and the names of the arm links.

#include <QString>

#include "robot/collision/move_check.h"
#include "robot/control/control_status.h"

namespace tiller {

/// Example: "Forearm collides with “crate” after 62 % of the path".
/// Threads  any
QString limitText(const collision::MoveLimit& limit, const collision::Surroundings& surroundings);

/// Name of the object with this index in the cell, as in collision::Contact::other. Examples: "“crate”", "the
/// floor".
QString surroundingsText(collision::Contact::With with, int other,
                         const collision::Surroundings& surroundings);

/// Explains why the collision check cannot include the object, and suggests actions. The text has no final
/// period.
QString unplacedText(const collision::UnplacedObject& object);

/// Name of the body that slows down a jog, e.g. "Upper arm", "“crate”".
QString limiterText(const control::Limiter& limiter, const collision::Surroundings& surroundings);

/// Name of a link, e.g. "Forearm"; the tool for collision::kToolLink.
QString linkText(int link);

}  // namespace tiller
