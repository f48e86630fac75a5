// SPDX-License-Identifier: MIT
#pragma once

// Display names of the controller modes, and the suggested actions. There is one table per enumeration, so
// that every mode has its own text.

#include <QString>

#include "robot/core/mode_lists.h"

namespace tiller {

struct ModeWords {
    QString text;    ///< a short name, e.g. "Protective stop"
    QString advice;  ///< meaning and next step, as sentences
};

ModeWords robotModeWords(RobotMode mode);
ModeWords safetyWords(SafetyStatus status);
ModeWords runtimeWords(RuntimeState state);

/// The safety value to display: the status, because it distinguishes more causes than the mode. If the status
/// permits motion and the mode does not, the mode is displayed.
SafetyStatus shownSafety(SafetyMode mode, SafetyStatus status);

}  // namespace tiller
