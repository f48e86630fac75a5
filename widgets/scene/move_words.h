// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What stands in the way of a move, as a sentence.

#include <QString>

#include "robot/collision/move_check.h"

namespace tiller {

/// "Forearm meets “crate” after 62 % of the way".
/// Threads  any
QString limitText(const collision::MoveLimit& limit, const collision::Surroundings& surroundings);

/// "Forearm"; the tool for collision::kToolLink.
QString linkText(int link);

}  // namespace tiller
