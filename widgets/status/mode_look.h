// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How each mode of the controller looks in the header: its own words, its own shape, a colour only where a
// person must look or act, and a sentence of advice. Also the one next step towards a robot that can be
// moved.

#include <QString>

#include "robot/station/link/session_state.h"
#include "widgets/common/state_chip.h"

namespace tiller {

struct ModeLook {
    QString text;
    StateChip::Shape shape = StateChip::Shape::None;
    StateChip::Emphasis emphasis = StateChip::Emphasis::Normal;
    QString advice;
    QString mark{};  ///< tells shapes of one kind apart
};

/// moving     the robot confirms motion; counts only in Running
/// freedrive  the hand may move the arm; so does this
ModeLook robotModeLook(RobotMode mode, bool moving, bool freedrive = false);
ModeLook safetyModeLook(SafetyStatus status);
/// What runs on the robot.
ModeLook runtimeLook(RuntimeState state);
/// Who is in control, and what for.
ModeLook controlLook(const SessionState& state);
/// The link's rate, late and lost packets and round trip, or what is wrong with it.
ModeLook linkLook(const SessionState& state);
/// In two or three words, what the link's quality means for the hand on the key.
QString linkCaption(const SessionState& state);

/// What the operator does next on the way to a robot that can be moved; one at a time.
enum class NextStep { None, Connect, PowerOn, ReleaseBrakes, Recover, TakeControl };

NextStep nextStep(const SessionState& state);
/// "Power on"; empty for None.
QString nextStepText(NextStep step);
QString nextStepAdvice(NextStep step);
/// Why it cannot be taken now, with what to do first; empty when it can.
QString nextStepObstacle(const SessionState& state);

}  // namespace tiller
