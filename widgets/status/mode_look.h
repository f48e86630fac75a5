// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Appearance of the controller modes in the header: text, shape, a colour if attention or action is required,
// and a suggested action. Also determines the operator's next step before the robot can move.

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

/// moving     the robot confirms motion; relevant only in the mode Running
/// freedrive  the arm can be moved by hand
ModeLook robotModeLook(RobotMode mode, bool moving, bool freedrive = false);
ModeLook safetyModeLook(SafetyStatus status);
ModeLook runtimeLook(RuntimeState state);
ModeLook controlLook(const SessionState& state);
/// The next three functions return the appearances of all known modes.
std::vector<ModeLook> robotModeLooks();
std::vector<ModeLook> safetyModeLooks();
std::vector<ModeLook> controlLooks();
/// Shows the packet rate, the numbers of late and lost packets, and the round-trip time, or the problem with
/// the connection.
ModeLook linkLook(const SessionState& state);
/// Returns the caption of the connection chip: "LINK" and the consequence of the connection quality for
/// jogging.
QString linkCaption(const SessionState& state);

/// The operator's next step before the robot can move.
enum class NextStep { None, Connect, PowerOn, ReleaseBrakes, Recover, TakeControl };

NextStep nextStep(const SessionState& state);
/// Label of the step, e.g. "Power on"; empty for None.
QString nextStepText(NextStep step);
QString nextStepAdvice(NextStep step);
/// The reason why the operator cannot take the step, with a suggested action; empty if the step is possible.
QString nextStepObstacle(const SessionState& state);

}  // namespace tiller
