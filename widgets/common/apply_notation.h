// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Changes the notation of lengths and rotations in a running application.

#include "robot/station/text/notation.h"

class QApplication;

namespace tiller {

/// Sets the notation and repaints all widgets (QEvent::StyleChange).
/// Threads  GUI
void applyNotation(QApplication& application, const Notation& notation);

}  // namespace tiller
