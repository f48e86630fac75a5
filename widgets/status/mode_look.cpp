// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/status/mode_look.h"

#include <QCoreApplication>

#include "widgets/common/format.h"
#include "widgets/session/texts.h"

namespace tiller {

namespace {

using Emphasis = StateChip::Emphasis;
using Shape = StateChip::Shape;

QString tr(const char* text) {
    return QCoreApplication::translate("ModeLook", text);
}

ModeLook stopLook(const char* text, SafetyMode mode) {
    return {tr(text), Shape::Octagon, Emphasis::Alarm, texts::safetyModeObstacle(mode)};
}

ModeLook operatorLook(const char* text, SafetyMode mode) {
    return {tr(text), Shape::Hand, Emphasis::OperatorNeeded, texts::safetyModeObstacle(mode)};
}

}  // namespace

ModeLook robotModeLook(RobotMode mode, bool moving) {
    const QString advice = texts::robotModeObstacle(mode);
    switch (mode) {
        case RobotMode::NoController:
            return {tr("No controller"), Shape::WarningTriangle, Emphasis::Warning, advice};
        case RobotMode::Disconnected:
            return {tr("Arm off line"), Shape::Cross, Emphasis::Warning, advice};
        case RobotMode::ConfirmSafety:
            return {tr("Confirm safety"), Shape::Hand, Emphasis::OperatorNeeded, advice};
        case RobotMode::Booting:
            return {tr("Booting"), Shape::Bars, Emphasis::Normal, advice};
        case RobotMode::PowerOff:
            return {tr("Power off"), Shape::Power, Emphasis::Normal, advice};
        case RobotMode::PowerOn:
            return {tr("Power on"), Shape::Bolt, Emphasis::Normal, advice};
        case RobotMode::Idle:
            return {tr("Idle"), Shape::Square, Emphasis::Normal, advice};
        case RobotMode::Backdrive:
            return {tr("Backdrive"), Shape::DoubleArrow, Emphasis::OperatorNeeded, advice};
        case RobotMode::Running:
            return moving ? ModeLook{tr("MOVING"), Shape::Triangle, Emphasis::Moving,
                                     tr("The robot confirms that the arm moves.")}
                          : ModeLook{tr("Running"), Shape::Dot, Emphasis::Normal,
                                     tr("Brakes are released. The arm stands still.")};
        case RobotMode::UpdatingFirmware:
            return {tr("Updating firmware"), Shape::DownArrow, Emphasis::Warning, advice};
    }
    return {robotModeName(mode), Shape::WarningTriangle, Emphasis::Warning, advice};
}

ModeLook safetyModeLook(SafetyMode mode) {
    switch (mode) {
        case SafetyMode::Normal:
            return {tr("Normal"), Shape::Circle, Emphasis::Normal, tr("No safety function is active.")};
        case SafetyMode::Reduced:
            return {tr("Reduced"), Shape::DownArrow, Emphasis::Normal,
                    tr("The robot keeps to its reduced limits.")};
        case SafetyMode::ProtectiveStop:
            return stopLook("Protective stop", mode);
        case SafetyMode::Recovery:
            return operatorLook("Recovery", mode);
        case SafetyMode::SafeguardStop:
            return stopLook("Safeguard stop", mode);
        case SafetyMode::SystemEmergencyStop:
            return stopLook("System emergency stop", mode);
        case SafetyMode::RobotEmergencyStop:
            return stopLook("Emergency stop", mode);
        case SafetyMode::Violation:
            return stopLook("Safety violation", mode);
        case SafetyMode::Fault:
            return stopLook("Safety fault", mode);
        case SafetyMode::ValidateJointId:
            return operatorLook("Validate joints", mode);
        case SafetyMode::Undefined:
            return {tr("Undefined"), Shape::Cross, Emphasis::Muted, texts::safetyModeObstacle(mode)};
        case SafetyMode::AutomaticModeSafeguardStop:
            return stopLook("Automatic safeguard stop", mode);
        case SafetyMode::SystemThreePositionEnablingStop:
            return stopLook("Enabling device stop", mode);
        case SafetyMode::TpThreePositionEnablingStop:
            return stopLook("Pendant enabling stop", mode);
        case SafetyMode::ImmiEmergencyStop:
            return stopLook("IMMI emergency stop", mode);
        case SafetyMode::ImmiSafeguardStop:
            return stopLook("IMMI safeguard stop", mode);
        case SafetyMode::ProfisafeWaitingForParameters:
            return operatorLook("PROFIsafe waiting", mode);
        case SafetyMode::ProfisafeAutomaticModeSafeguardStop:
            return stopLook("PROFIsafe automatic stop", mode);
        case SafetyMode::ProfisafeSafeguardStop:
            return stopLook("PROFIsafe safeguard stop", mode);
        case SafetyMode::ProfisafeEmergencyStop:
            return stopLook("PROFIsafe emergency stop", mode);
        case SafetyMode::SafetyApiSafeguardStop:
            return stopLook("Safety API stop", mode);
    }
    // A number from newer software: never taken for normal.
    return {safetyModeName(mode), Shape::Octagon, Emphasis::Alarm, texts::safetyModeObstacle(mode)};
}

ModeLook controlLook(const SessionState& state) {
    const QString place = state.remoteControl ? tr("Remote") : tr("Local");
    switch (state.control) {
        case ControlState::Taking:
            return {tr("Taking control…"), Shape::Bars, Emphasis::Normal, {}};
        case ControlState::InControl: {
            const QString what = state.jogActive ? tr("Jog") : state.moving ? tr("Move") : tr("Ready");
            return {(state.remoteControl ? place : tr("In control")) + QStringLiteral(" · ") + what,
                    Shape::None, Emphasis::Normal, state.controlReason};
        }
        case ControlState::Refused:
            return {tr("Refused"), Shape::Hand, Emphasis::OperatorNeeded, state.controlReason};
        case ControlState::None:
            break;
    }
    if (state.link == LinkState::Disconnected) {
        return {QStringLiteral("–"), Shape::None, Emphasis::Muted, {}};
    }
    return {state.remoteControl ? tr("Not in control") : tr("Local · monitoring"), Shape::None,
            Emphasis::Muted, state.controlReason};
}

ModeLook linkLook(const SessionState& state) {
    const LinkQuality& q = state.quality;
    const QString more = tr("%1 packets, %2 late, %3 lost").arg(q.packets).arg(q.late).arg(q.lost);
    switch (state.link) {
        case LinkState::Disconnected:
            return {QStringLiteral("–"), Shape::None, Emphasis::Muted, tr("No robot connected")};
        case LinkState::Connecting:
            return {tr("Connecting…"), Shape::Bars, Emphasis::Normal, state.linkReason};
        case LinkState::Stale:
            return {tr("Late: %1 s").arg(q.ageMs / 1e3, 0, 'f', 1), Shape::WarningTriangle, Emphasis::Warning,
                    state.linkReason.isEmpty() ? more : state.linkReason};
        case LinkState::Lost:
            return {tr("NO DATA"), Shape::Cross, Emphasis::Alarm, state.linkReason};
        case LinkState::Live:
            break;
    }
    QString text = tr("%1 Hz · %2 late").arg(q.rateHz, 0, 'f', 0).arg(q.late);
    if (q.lost > 0) {
        text += tr(" · %1 lost").arg(q.lost);
    }
    if (q.roundTripMs > 0) {
        text += QStringLiteral(" · %1 ms").arg(q.roundTripMs, 0, 'f', 1);
    }
    return {text, Shape::None, Emphasis::Normal, more};
}

NextStep nextStep(const SessionState& state) {
    if (state.link == LinkState::Disconnected) {
        return NextStep::Connect;
    }
    if (state.link != LinkState::Live) {
        return NextStep::None;
    }
    if (state.safetyMode == SafetyMode::ProtectiveStop) {
        return NextStep::UnlockProtectiveStop;
    }
    if (!allowsMotion(state.safetyMode)) {
        return NextStep::None;
    }
    switch (state.robotMode) {
        case RobotMode::PowerOff:
            return NextStep::PowerOn;
        case RobotMode::Idle:
            return NextStep::ReleaseBrakes;
        case RobotMode::Running:
            return state.control == ControlState::None || state.control == ControlState::Refused
                       ? NextStep::TakeControl
                       : NextStep::None;
        default:
            return NextStep::None;
    }
}

QString nextStepText(NextStep step) {
    switch (step) {
        case NextStep::None:
            break;
        case NextStep::Connect:
            return tr("Connect…");
        case NextStep::PowerOn:
            return tr("Power on");
        case NextStep::ReleaseBrakes:
            return tr("Release brakes");
        case NextStep::UnlockProtectiveStop:
            return tr("Unlock…");
        case NextStep::TakeControl:
            return tr("Take control");
    }
    return {};
}

QString nextStepAdvice(NextStep step) {
    switch (step) {
        case NextStep::None:
            break;
        case NextStep::Connect:
            return tr("Choose the simulator or the address of a robot");
        case NextStep::PowerOn:
            return tr("Powers the arm. Brakes stay engaged.");
        case NextStep::ReleaseBrakes:
            return tr("The arm may sag by a few millimetres. Keep clear.");
        case NextStep::UnlockProtectiveStop:
            return tr("Look at the arm first: clear what it ran into. Possible five seconds after the stop.");
        case NextStep::TakeControl:
            return tr("Starts the control program on the robot, which stops any other program.");
    }
    return {};
}

}  // namespace tiller
