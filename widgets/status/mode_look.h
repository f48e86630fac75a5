// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Appearance of the controller's modes in the header: text, shape, a colour if attention or action is required, and
// a suggested action. Also the next step towards a robot that can move.

#include <QString>
#include <vector>

#include "robot/station/link/session_state.h"
#include "widgets/common/state_chip.h"

namespace tiller {

struct ModeLook {
    QString text;
    StateChip::Shape shape = StateChip::Shape::None;
    StateChip::Emphasis emphasis = StateChip::Emphasis::Normal;
    QString advice;
    QString mark{};  ///< distinguishes states with the same shape
};

/// moving     the robot confirms motion; only relevant in Running
/// freedrive  the arm can be moved by hand
ModeLook robotModeLook(RobotMode mode, bool moving, bool freedrive = false);
ModeLook safetyModeLook(SafetyStatus status);
/// Appearance of the runtime state.
ModeLook runtimeLook(RuntimeState state);
/// Appearance of the control state.
ModeLook controlLook(const SessionState& state);
/// All appearances that these functions return for known modes.
std::vector<ModeLook> robotModeLooks();
std::vector<ModeLook> safetyModeLooks();
std::vector<ModeLook> controlLooks();
/// Rate, late and lost packets and round trip of the connection, or its problem.
ModeLook linkLook(const SessionState& state);
/// The consequence of the connection quality for jogging, in two or three words.
QString linkCaption(const SessionState& state);

/// The next step of the operator towards a robot that can move.
enum class NextStep { None, Connect, PowerOn, ReleaseBrakes, Recover, TakeControl };

NextStep nextStep(const SessionState& state);
/// e.g. "Power on"; empty for None.
QString nextStepText(NextStep step);
QString nextStepAdvice(NextStep step);
/// The reason why the step is not possible now, with a suggested action; empty if it is.
QString nextStepObstacle(const SessionState& state);

}  // namespace tiller
