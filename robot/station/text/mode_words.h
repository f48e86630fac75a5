// SPDX-License-Identifier: MIT
#pragma once

// Names of the controller modes on screen, and the suggested action: one table per enumeration, so that every
// mode has a text and no two share one.

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

/// Selects which of the two safety values of a controller to show. The status distinguishes causes; if the
/// two disagree about whether the arm may move, the one that forbids motion takes precedence.
SafetyStatus shownSafety(SafetyMode mode, SafetyStatus status);

}  // namespace tiller
