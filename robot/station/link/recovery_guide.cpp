// SPDX-License-Identifier: MIT
#include "robot/station/link/recovery_guide.h"
#include "robot/station/link/obstacles.h"

#include <QCoreApplication>
#include <cmath>

#include "robot/station/text/texts.h"

namespace tiller {
namespace {

/// Translation context of this file for lupdate.
struct RecoveryGuideText {
    Q_DECLARE_TR_FUNCTIONS(RecoveryGuide)
};

/// The standard steps for powering on after the safety system has returned to normal.
RecoveryGuide powerUpGuide(const SessionState& state, RecoveryStep next) {
    RecoveryGuide guide;
    guide.step = next;
    guide.title = RecoveryGuideText::tr("Safety mode is Normal again");
    const ModeWords mode = robotModeWords(state.robotMode);
    guide.what = mode.advice;
    switch (next) {
        case RecoveryStep::PowerOn:
        case RecoveryStep::ReleaseBrakes:
            break;
        case RecoveryStep::Done:
            guide.takesControl = state.control != ControlState::InControl && !state.monitorOnly;
            guide.what = state.monitorOnly     ? texts::monitorOnlyObstacle()
                         : !guide.takesControl ? RecoveryGuideText::tr(
                                                     "The arm can be moved. Motions interrupted by the stop "
                                                     "do not resume. Press the button again for each motion.")
                                               : RecoveryGuideText::tr(
                                                     "The arm is ready. Take control to move the arm, or "
                                                     "continue on the teach pendant.");
            if (state.control == ControlState::Taking) {
                guide.waiting = RecoveryGuideText::tr("Taking control…");
            }
            break;
        default:
            guide.waiting = mode.advice;
            break;
    }
    return guide;
}

/// The step that the safety state requires.
RecoveryGuide guideFor(const SessionState& state, double sinceStop) {
    RecoveryGuide guide;
    if (!state.hasData() || state.link != LinkState::Live) {
        guide.title = RecoveryGuideText::tr("No data from the robot");
        guide.what = state.linkReason;
        guide.waiting = RecoveryGuideText::tr("Waiting for the connection…");
        return guide;
    }
    const SafetyStatus status = state.safety();
    const RecoveryStep next = dashboard::nextRecoveryStep(status, state.robotMode);
    if (allowsMotion(status)) {
        return powerUpGuide(state, next);
    }
    const ModeWords words = safetyWords(status);
    guide.title = words.text;
    guide.what = words.advice;
    guide.step = next;
    switch (next) {
        case RecoveryStep::Unlock: {
            guide.checks = {RecoveryGuideText::tr(
                                "I have inspected the arm. No one is touching it, and nothing is trapped."),
                            RecoveryGuideText::tr("The cause of the stop is known and has been removed."),
                            RecoveryGuideText::tr("Payload and TCP match the mounted tool.")};
            const double left = dashboard::kUnlockAfter - sinceStop;
            if (left > 0) {
                guide.countdown = static_cast<int>(std::ceil(left));
                guide.waiting = RecoveryGuideText::tr("Unlocking is available in %1 s").arg(guide.countdown);
            }
            break;
        }
        case RecoveryStep::RestartSafety:
            guide.checks = {
                RecoveryGuideText::tr("I have inspected the arm and the robot's log, and I know the cause."),
                RecoveryGuideText::tr("The cause has been removed, and no one is within reach of the arm.")};
            break;
        default:
            guide.waiting = RecoveryGuideText::tr(
                "No action is needed in Tiller. This state ends when the cause is removed.");
            break;
    }
    return guide;
}

}  // namespace

RecoveryGuide recoveryGuide(const SessionState& state, double sinceStop) {
    RecoveryGuide guide = guideFor(state, sinceStop);
    const bool asksTheRobot = guide.step != RecoveryStep::Done && !guide.keyText().isEmpty();
    if (const QString why = serviceObstacle(state); asksTheRobot && !why.isEmpty()) {
        guide.waiting = why;
    }
    return guide;
}

QString RecoveryGuide::keyText() const {
    switch (step) {
        case RecoveryStep::Unlock:
            return RecoveryGuideText::tr("Unlock");
        case RecoveryStep::RestartSafety:
            return RecoveryGuideText::tr("Restart safety");
        case RecoveryStep::PowerOn:
            return RecoveryGuideText::tr("Power on");
        case RecoveryStep::ReleaseBrakes:
            return RecoveryGuideText::tr("Release brakes");
        case RecoveryStep::Done:
            return takesControl ? RecoveryGuideText::tr("Take control") : RecoveryGuideText::tr("Close");
        default:
            return {};
    }
}

}  // namespace tiller
