// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/session/recovery_guide.h"

#include <QCoreApplication>
#include <cmath>

#include "widgets/session/texts.h"

namespace tiller {
namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("RecoveryGuide", text);
}

/// After the safety system let go: the ordinary way up.
RecoveryGuide wayUp(const SessionState& state) {
    RecoveryGuide guide;
    guide.title = tr("Safety is normal again");
    const ModeWords mode = robotModeWords(state.robotMode);
    guide.what = mode.advice;
    switch (state.robotMode) {
        case RobotMode::PowerOff:
            guide.step = RecoveryStep::PowerOn;
            break;
        case RobotMode::Idle:
            guide.step = RecoveryStep::ReleaseBrakes;
            break;
        case RobotMode::Running:
            guide.step =
                state.control == ControlState::InControl ? RecoveryStep::Done : RecoveryStep::TakeControl;
            guide.what =
                guide.step == RecoveryStep::Done
                    ? tr("The arm can be moved. What was armed before the stop does not move it: every "
                         "motion needs a new press.")
                    : tr("The arm is ready. Take control to move it, or go on on the teach pendant.");
            if (state.control == ControlState::Taking) {
                guide.waiting = tr("Taking control…");
            }
            break;
        default:
            guide.waiting = mode.advice;
            break;
    }
    return guide;
}

/// The step as the safety system asks for it.
RecoveryGuide guideFor(const SessionState& state, double sinceStop) {
    RecoveryGuide guide;
    if (!state.hasData() || state.link != LinkState::Live) {
        guide.title = tr("No data from the robot");
        guide.what = state.linkReason;
        guide.waiting = tr("Waiting for the connection");
        return guide;
    }
    const SafetyStatus status = state.safety();
    if (allowsMotion(status)) {
        return wayUp(state);
    }
    const ModeWords words = safetyWords(status);
    guide.title = words.text;
    guide.what = words.advice;
    switch (status) {
        case SafetyMode::ProtectiveStop: {
            guide.checks = {tr("I looked at the arm: nobody touches it, nothing is caught."),
                            tr("What stopped it is known and removed."),
                            tr("Payload and TCP are those of the tool that is mounted.")};
            guide.step = RecoveryStep::Unlock;
            const double left = kUnlockAfter - sinceStop;
            if (left > 0) {
                guide.countdown = static_cast<int>(std::ceil(left));
                guide.waiting = tr("Possible in %1 s").arg(guide.countdown);
            }
            break;
        }
        case SafetyMode::Violation:
        case SafetyMode::Fault:
            guide.checks = {tr("I looked at the arm and at the robot's log: the cause is known."),
                            tr("The cause is removed, and nobody is in the arm's reach.")};
            guide.step = RecoveryStep::RestartSafety;
            break;
        default:
            guide.waiting = tr("Nothing to press here: it ends when its cause is gone.");
            break;
    }
    return guide;
}

}  // namespace

RecoveryGuide recoveryGuide(const SessionState& state, double sinceStop) {
    RecoveryGuide guide = guideFor(state, sinceStop);
    const bool asksTheRobot =
        guide.step == RecoveryStep::Unlock || guide.step == RecoveryStep::RestartSafety ||
        guide.step == RecoveryStep::PowerOn || guide.step == RecoveryStep::ReleaseBrakes;
    if (const QString why = texts::serviceObstacle(state); asksTheRobot && !why.isEmpty()) {
        guide.waiting = why;
    }
    return guide;
}

QString recoveryStepText(RecoveryStep step) {
    switch (step) {
        case RecoveryStep::None:
            break;
        case RecoveryStep::Unlock:
            return tr("Unlock");
        case RecoveryStep::RestartSafety:
            return tr("Restart safety");
        case RecoveryStep::PowerOn:
            return tr("Power on");
        case RecoveryStep::ReleaseBrakes:
            return tr("Release brakes");
        case RecoveryStep::TakeControl:
            return tr("Take control");
        case RecoveryStep::Done:
            return tr("Close");
    }
    return {};
}

}  // namespace tiller
