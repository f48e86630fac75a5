// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/status/mode_look.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

#include "robot/dashboard/recovery.h"
#include "robot/station/link/obstacles.h"
#include "robot/station/text/format.h"
#include "robot/station/text/texts.h"

namespace tiller {

namespace {

using Emphasis = StateChip::Emphasis;
using Shape = StateChip::Shape;

/// Translation context of this file for lupdate.
struct ModeLookText {
    Q_DECLARE_TR_FUNCTIONS(ModeLook)
};

/// Adds the appearance to a name from mode_words.h.
template <class Mode>
struct Row {
    Mode mode;
    Shape shape;
    Emphasis emphasis;
    const char* mark = "";
};

constexpr auto kRobotModes = std::to_array<Row<RobotMode>>({
    {RobotMode::NoController, Shape::WarningTriangle, Emphasis::Warning},
    {RobotMode::Disconnected, Shape::Cross, Emphasis::Warning},
    {RobotMode::ConfirmSafety, Shape::Hand, Emphasis::OperatorNeeded},
    {RobotMode::Booting, Shape::Bars, Emphasis::Normal},
    {RobotMode::PowerOff, Shape::Power, Emphasis::Normal},
    {RobotMode::PowerOn, Shape::Bolt, Emphasis::Normal},
    {RobotMode::Idle, Shape::Square, Emphasis::Normal},
    {RobotMode::Backdrive, Shape::DoubleArrow, Emphasis::OperatorNeeded},
    {RobotMode::Running, Shape::Dot, Emphasis::Normal},
    {RobotMode::UpdatingFirmware, Shape::DownArrow, Emphasis::Warning},
});

// Stops have the shape of an octagon. Common stops are marked with a letter, and stops of newer controller
// software with a number.
constexpr auto kSafety = std::to_array<Row<SafetyStatus>>({
    {SafetyMode::Normal, Shape::Circle, Emphasis::Normal},
    {SafetyMode::Reduced, Shape::DownArrow, Emphasis::Normal},
    {SafetyMode::ProtectiveStop, Shape::Octagon, Emphasis::Alarm, "P"},
    {SafetyMode::Recovery, Shape::Hand, Emphasis::OperatorNeeded},
    {SafetyMode::SafeguardStop, Shape::Octagon, Emphasis::Alarm, "G"},
    {SafetyMode::SystemEmergencyStop, Shape::Octagon, Emphasis::Alarm, "S"},
    {SafetyMode::RobotEmergencyStop, Shape::Octagon, Emphasis::Alarm, "E"},
    {SafetyMode::Violation, Shape::Octagon, Emphasis::Alarm, "V"},
    {SafetyMode::Fault, Shape::Octagon, Emphasis::Alarm, "F"},
    {SafetyMode::ValidateJointId, Shape::Hand, Emphasis::OperatorNeeded, "J"},
    {SafetyMode::Undefined, Shape::Cross, Emphasis::Muted},
    {SafetyMode::AutomaticModeSafeguardStop, Shape::Octagon, Emphasis::Alarm, "A"},
    {SafetyMode::SystemThreePositionEnablingStop, Shape::Octagon, Emphasis::Alarm, "3"},
    {SafetyMode::TpThreePositionEnablingStop, Shape::Octagon, Emphasis::Alarm, "14"},
    {SafetyMode::ImmiEmergencyStop, Shape::Octagon, Emphasis::Alarm, "15"},
    {SafetyMode::ImmiSafeguardStop, Shape::Octagon, Emphasis::Alarm, "16"},
    {SafetyMode::ProfisafeWaitingForParameters, Shape::Hand, Emphasis::OperatorNeeded, "F"},
    {SafetyMode::ProfisafeAutomaticModeSafeguardStop, Shape::Octagon, Emphasis::Alarm, "18"},
    {SafetyMode::ProfisafeSafeguardStop, Shape::Octagon, Emphasis::Alarm, "19"},
    {SafetyMode::ProfisafeEmergencyStop, Shape::Octagon, Emphasis::Alarm, "20"},
    {SafetyMode::SafetyApiSafeguardStop, Shape::Octagon, Emphasis::Alarm, "22"},
    {kIoPlaneStop, Shape::Octagon, Emphasis::Alarm, "23"},
});

// The mark "…" means that the state has not been reached yet.
constexpr auto kRuntime = std::to_array<Row<RuntimeState>>({
    {RuntimeState::Stopping, Shape::Square, Emphasis::Normal, "…"},
    {RuntimeState::Stopped, Shape::Square, Emphasis::Muted},
    {RuntimeState::Playing, Shape::Triangle, Emphasis::Normal},
    {RuntimeState::Pausing, Shape::Pause, Emphasis::Normal, "…"},
    {RuntimeState::Paused, Shape::Pause, Emphasis::Normal},
    {RuntimeState::Resuming, Shape::Triangle, Emphasis::Normal, "…"},
});

template <class Mode, std::size_t N>
ModeLook lookOf(const std::array<Row<Mode>, N>& table, Mode mode, const ModeWords& words, Row<Mode> unknown) {
    const auto found =
        std::find_if(table.begin(), table.end(), [mode](const auto& r) { return r.mode == mode; });
    const Row<Mode>& row = found == table.end() ? unknown : *found;
    return {words.text, row.shape, row.emphasis, words.advice, QString::fromUtf8(row.mark)};
}

}  // namespace

ModeLook robotModeLook(RobotMode mode, bool moving, bool freedrive) {
    if (mode == RobotMode::Running && freedrive) {
        return {ModeLookText::tr("FREEDRIVE"),
                Shape::Hand,
                Emphasis::OperatorNeeded,
                ModeLookText::tr("The arm can be moved by hand."),
                {}};
    }
    if (mode == RobotMode::Running && moving) {
        return {ModeLookText::tr("MOVING"),
                Shape::Triangle,
                Emphasis::Moving,
                ModeLookText::tr("The robot reports that the arm is moving."),
                {}};
    }
    return lookOf(kRobotModes, mode, robotModeWords(mode),
                  {mode, Shape::WarningTriangle, Emphasis::Warning, "?"});
}

ModeLook safetyModeLook(SafetyStatus status) {
    // An unknown value from newer controller software is shown as an alarm.
    return lookOf(kSafety, status, safetyWords(status), {status, Shape::Octagon, Emphasis::Alarm, "?"});
}

ModeLook runtimeLook(RuntimeState state) {
    return lookOf(kRuntime, state, runtimeWords(state),
                  {state, Shape::WarningTriangle, Emphasis::Warning, "?"});
}

ModeLook controlLook(const SessionState& state) {
    const QString dot = QStringLiteral(" · ");
    QStringList parts;
    if (state.controlPlaceKnown) {
        parts << (state.remoteControl ? ModeLookText::tr("Remote") : ModeLookText::tr("Local"));
    }
    if (state.operationalMode == QLatin1String("MANUAL")) {
        parts << ModeLookText::tr("Manual");
    } else if (state.operationalMode == QLatin1String("AUTOMATIC")) {
        parts << ModeLookText::tr("Automatic");
    }
    const QString place = parts.join(dot);
    if (state.link == LinkState::Lost) {
        // The control and program states in the session are outdated.
        return {ModeLookText::tr("NO DATA"), Shape::None, Emphasis::Muted, state.linkReason};
    }
    if (state.hasData() && !state.isFresh() && state.control != ControlState::Taking) {
        return {ModeLookText::tr("Data late"), Shape::None, Emphasis::Muted, state.controlReason};
    }
    switch (state.control) {
        case ControlState::Taking:
            return {ModeLookText::tr("Taking control…"), Shape::Bars, Emphasis::Normal, {}};
        case ControlState::InControl: {
            const ModeLook program = runtimeLook(state.runtimeState);
            if (state.programRuns && state.hasData() &&
                (state.runtimeState == RuntimeState::Pausing || state.runtimeState == RuntimeState::Paused)) {
                // The teach pendant or another client has paused the program of this window.
                return {(state.remoteControl ? place : ModeLookText::tr("In control")) + dot + program.text,
                        program.shape, program.emphasis, state.controlReason, program.mark};
            }
            const QString what = state.freedriveActive ? ModeLookText::tr("Freedrive")
                                 : state.jogActive     ? ModeLookText::tr("Jog")
                                 : state.moving        ? ModeLookText::tr("Move")
                                                       : ModeLookText::tr("Ready");
            return {(state.remoteControl ? place : ModeLookText::tr("In control")) + dot + what, Shape::None,
                    Emphasis::Normal, state.controlReason};
        }
        case ControlState::Refused:
            return {ModeLookText::tr("Refused"), Shape::Hand, Emphasis::OperatorNeeded, state.controlReason};
        case ControlState::None:
            break;
    }
    if (state.link == LinkState::Disconnected) {
        return {QStringLiteral("–"), Shape::None, Emphasis::Muted, {}};
    }
    if (state.hasData() && state.runtimeState != RuntimeState::Stopped && !state.programAbandoned) {
        // A program of another client may be moving the arm.
        const ModeLook program = runtimeLook(state.runtimeState);
        QString name =
            state.runningProgram.isEmpty() ? QString() : QStringLiteral(": ") + state.runningProgram;
        if (!state.programNode.isEmpty()) {
            name += QStringLiteral(" › ") + state.programNode;
        }
        return {(parts << program.text).join(dot), program.shape, program.emphasis, program.advice + name,
                program.mark};
    }
    return {state.remoteControl ? ModeLookText::tr("Not in control")
                                : (parts << ModeLookText::tr("Monitoring")).join(dot),
            Shape::None, Emphasis::Muted, state.controlReason};
}

std::vector<ModeLook> robotModeLooks() {
    std::vector<ModeLook> looks{robotModeLook(RobotMode::Running, true),
                                robotModeLook(RobotMode::Running, false, true)};
    for (const Row<RobotMode>& row : kRobotModes) {
        looks.push_back(robotModeLook(row.mode, false));
    }
    return looks;
}

std::vector<ModeLook> safetyModeLooks() {
    std::vector<ModeLook> looks;
    for (const Row<SafetyStatus>& row : kSafety) {
        looks.push_back(safetyModeLook(row.mode));
    }
    return looks;
}

std::vector<ModeLook> controlLooks() {
    std::vector<ModeLook> looks;
    SessionState state;
    looks.push_back(controlLook(state));
    state.sequence = 1;
    state.link = LinkState::Lost;
    looks.push_back(controlLook(state));
    state.link = LinkState::Stale;
    looks.push_back(controlLook(state));
    state.link = LinkState::Live;
    const auto add = [&looks, &state](ControlState control) {
        state.control = control;
        looks.push_back(controlLook(state));
    };
    add(ControlState::Taking);
    add(ControlState::Refused);
    for (const bool remote : {false, true}) {
        for (const char* mode : {"", "MANUAL", "AUTOMATIC"}) {
            state.remoteControl = remote;
            state.operationalMode = QLatin1String(mode);
            for (const Row<RuntimeState>& row : kRuntime) {
                state.runtimeState = row.mode;
                add(ControlState::None);
            }
            for (bool SessionState::*doing :
                 {&SessionState::moving, &SessionState::jogActive, &SessionState::freedriveActive}) {
                add(ControlState::InControl);
                state.*doing = true;
            }
            add(ControlState::InControl);
            state.moving = state.jogActive = state.freedriveActive = false;
        }
    }
    return looks;
}

namespace {

enum class Worth { Good, Gaps, Slow };

Worth worthOf(const LinkQuality& q) {
    // Occasional delays of a millisecond are normal on any PC and do not stop a jog. Only frequent delays or
    // repeated losses are reported.
    constexpr std::uint64_t kLostOf = 1000;
    constexpr std::uint64_t kLateOf = 5;
    const PacketCounts& now = q.recent;
    if (now.lost * kLostOf > now.packets || (now.packets > 1000 && now.late * kLateOf > now.packets)) {
        return Worth::Gaps;
    }
    constexpr double kNoticeableMs = 20;
    return q.roundTripMs > kNoticeableMs ? Worth::Slow : Worth::Good;
}

/// Consequence of the connection quality for jogging.
QString linkConsequence(const LinkQuality& q) {
    const Worth worth = worthOf(q);
    if (worth == Worth::Gaps) {
        return ModeLookText::tr(
            "Packets are late or lost: jogging may stop and plots may have gaps. Use a cable instead of a "
            "wireless link, and close other programs.");
    }
    if (worth == Worth::Slow) {
        return ModeLookText::tr(
            "Commands take longer than 20 ms: the arm responds with a delay. Jog slowly.");
    }
    return ModeLookText::tr("Good: the arm responds immediately and stops within 250 ms if the link fails.");
}

}  // namespace

ModeLook linkLook(const SessionState& state) {
    const LinkQuality& q = state.quality;
    const QString more =
        ModeLookText::tr("Last 10 s: %1 packets, %2 late, %3 lost")
            .arg(q.recent.packets)
            .arg(q.recent.late)
            .arg(q.recent.lost) +
        QLatin1Char('\n') +
        ModeLookText::tr("Since connecting: %1 packets, %2 late, %3 lost")
            .arg(q.all.packets)
            .arg(q.all.late)
            .arg(q.all.lost) +
        QLatin1Char('\n') +
        ModeLookText::tr(
            "A packet counts as late when it arrives more than half a period after its expected time.");
    switch (state.link) {
        case LinkState::Disconnected:
            return {QStringLiteral("–"), Shape::None, Emphasis::Muted,
                    ModeLookText::tr("No robot connected")};
        case LinkState::Connecting:
            return {ModeLookText::tr("Connecting…"), Shape::Bars, Emphasis::Normal, state.linkReason};
        case LinkState::Stale:
            return {ModeLookText::tr("Late: %1 s").arg(q.ageMs / 1e3, 0, 'f', 1), Shape::WarningTriangle,
                    Emphasis::Warning, state.linkReason.isEmpty() ? more : state.linkReason};
        case LinkState::Lost:
            return {ModeLookText::tr("NO DATA"), Shape::Cross, Emphasis::Alarm, state.linkReason};
        case LinkState::Live:
            break;
    }
    QString text = ModeLookText::tr("%1 Hz").arg(q.rateHz, 0, 'f', 0);
    if (worthOf(q) == Worth::Gaps) {
        // Show the losses only if they affect jogging.
        text += ModeLookText::tr(" · %1 late").arg(q.recent.late);
        if (q.recent.lost > 0) {
            text += ModeLookText::tr(" · %1 lost").arg(q.recent.lost);
        }
    }
    if (q.roundTripMs > 0) {
        text += QStringLiteral(" · %1 ms").arg(q.roundTripMs, 0, 'f', 1);
    }
    return {text, Shape::None, Emphasis::Normal, more + QLatin1Char('\n') + linkConsequence(q)};
}

QString linkCaption(const SessionState& state) {
    if (state.link == LinkState::Stale && state.control == ControlState::InControl) {
        return ModeLookText::tr("LINK · JOG STOPS");
    }
    if (state.link != LinkState::Live) {
        return ModeLookText::tr("LINK");
    }
    switch (worthOf(state.quality)) {
        case Worth::Gaps:
            return ModeLookText::tr("LINK · JOG MAY STOP");
        case Worth::Slow:
            return ModeLookText::tr("LINK · ARM LAGS");
        case Worth::Good:
            break;
    }
    return ModeLookText::tr("LINK · GOOD");
}

NextStep nextStep(const SessionState& state) {
    if (state.link == LinkState::Disconnected) {
        return NextStep::Connect;
    }
    if (state.link != LinkState::Live || state.monitorOnly) {
        return NextStep::None;
    }
    const bool isUnavailable = !serviceObstacle(state).isEmpty();
    switch (dashboard::nextRecoveryStep(state.safety(), state.robotMode)) {
        case dashboard::RecoveryStep::PowerOn:
            return isUnavailable ? NextStep::None : NextStep::PowerOn;
        case dashboard::RecoveryStep::ReleaseBrakes:
            return isUnavailable ? NextStep::None : NextStep::ReleaseBrakes;
        case dashboard::RecoveryStep::Done:
            return state.control == ControlState::None || state.control == ControlState::Refused
                       ? NextStep::TakeControl
                       : NextStep::None;
        case dashboard::RecoveryStep::Look:
            return NextStep::None;
        default:  // the safety system prevents motion
            return NextStep::Recover;
    }
}

QString nextStepObstacle(const SessionState& state) {
    return nextStep(state) == NextStep::TakeControl && state.remoteNeeded ? texts::remoteObstacle()
                                                                          : QString();
}

QString nextStepText(NextStep step) {
    switch (step) {
        case NextStep::None:
            break;
        case NextStep::Connect:
            return ModeLookText::tr("Connect…");
        case NextStep::PowerOn:
            return ModeLookText::tr("Power on");
        case NextStep::ReleaseBrakes:
            return ModeLookText::tr("Release brakes");
        case NextStep::Recover:
            return ModeLookText::tr("Recover…");
        case NextStep::TakeControl:
            return ModeLookText::tr("Take control");
    }
    return {};
}

QString nextStepAdvice(NextStep step) {
    switch (step) {
        case NextStep::None:
            break;
        case NextStep::Connect:
            return ModeLookText::tr("Select the simulator or enter the address of a robot.");
        case NextStep::PowerOn:
            return ModeLookText::tr("Powers on the arm. The brakes stay engaged.");
        case NextStep::ReleaseBrakes:
            return ModeLookText::tr("The arm may sag by a few millimetres. Keep clear.");
        case NextStep::Recover:
            return ModeLookText::tr(
                "Shows the cause of the stop, the five seconds before it, and the recovery steps. The arm "
                "does not move.");
        case NextStep::TakeControl:
            return ModeLookText::tr(
                "Starts the control program on the robot. Asks for confirmation before stopping another "
                "program.");
    }
    return {};
}

}  // namespace tiller
