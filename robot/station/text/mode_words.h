// SPDX-License-Identifier: MIT
#pragma once

// What each mode of the controller is called on screen, and what it asks of the operator: one table for each
// enumeration, so that no mode is without words and no two share them.

#include <QString>

#include "robot/core/mode_lists.h"

namespace tiller {

struct ModeWords {
    QString text;    ///< a few words: "Protective stop"
    QString advice;  ///< meaning and next step, as sentences
};

ModeWords robotModeWords(RobotMode mode);
ModeWords safetyWords(SafetyStatus status);
ModeWords runtimeWords(RuntimeState state);

/// What to show of the two safety values a controller sends. The status tells causes apart; where the two
/// disagree about whether the arm may move, the one that says no is right.
SafetyStatus shownSafety(SafetyMode mode, SafetyStatus status);

}  // namespace tiller
