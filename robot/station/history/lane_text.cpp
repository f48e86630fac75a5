// SPDX-License-Identifier: MIT
#include "robot/station/history/lane_text.h"

#include <QCoreApplication>

namespace tiller {

namespace {

/// Translation context of this file for lupdate.
struct StateLaneText {
    Q_DECLARE_TR_FUNCTIONS(StateLane)
};

QString safetyWord(SafetyMode mode) {
    switch (mode) {
        case SafetyMode::ProtectiveStop:
            return StateLaneText::tr("Protective stop");
        case SafetyMode::Recovery:
            return StateLaneText::tr("Recovery");
        case SafetyMode::SafeguardStop:
        case SafetyMode::AutomaticModeSafeguardStop:
        case SafetyMode::ImmiSafeguardStop:
        case SafetyMode::ProfisafeSafeguardStop:
        case SafetyMode::ProfisafeAutomaticModeSafeguardStop:
        case SafetyMode::SafetyApiSafeguardStop:
            return StateLaneText::tr("Safeguard stop");
        case SafetyMode::SystemEmergencyStop:
        case SafetyMode::RobotEmergencyStop:
        case SafetyMode::ImmiEmergencyStop:
        case SafetyMode::ProfisafeEmergencyStop:
            return StateLaneText::tr("Emergency stop");
        case SafetyMode::SystemThreePositionEnablingStop:
        case SafetyMode::TpThreePositionEnablingStop:
            return StateLaneText::tr("Enabling device released");
        case SafetyMode::Violation:
            return StateLaneText::tr("Safety violation");
        case SafetyMode::Fault:
            return StateLaneText::tr("Safety fault");
        default:
            return StateLaneText::tr("Stopped");
    }
}

QString robotModeWord(RobotMode mode) {
    switch (mode) {
        case RobotMode::PowerOff:
            return StateLaneText::tr("Power off");
        case RobotMode::Booting:
        case RobotMode::PowerOn:
            return StateLaneText::tr("Starting");
        case RobotMode::Idle:
            return StateLaneText::tr("Brakes on");
        case RobotMode::Backdrive:
            return StateLaneText::tr("Backdrive");
        default:
            return StateLaneText::tr("Not running");
    }
}

}  // namespace

LaneEntry noDataEntry() {
    return {LaneKind::NoData, StateLaneText::tr("No data")};
}

std::optional<LaneEntry> hinderedEntry(RobotMode robotMode, SafetyMode safetyMode) {
    if (!allowsMotion(safetyMode) && safetyMode != SafetyMode::Undefined) {
        return LaneEntry{LaneKind::Stopped, safetyWord(safetyMode)};
    }
    if (robotMode != RobotMode::Running) {
        return LaneEntry{LaneKind::Off, robotModeWord(robotMode)};
    }
    return std::nullopt;
}

LaneEntry motionEntry(bool moving) {
    return moving ? LaneEntry{LaneKind::Moving, StateLaneText::tr("Moving")}
                  : LaneEntry{LaneKind::Idle, StateLaneText::tr("At standstill")};
}

LaneEntry laneEntry(const SessionState& state, const QString& jogLabel, const QString& stepLabel) {
    if (!state.hasData()) {
        return noDataEntry();
    }
    if (!state.isFresh()) {
        return {LaneKind::NoData, StateLaneText::tr("Late data")};  // the arm may be moving, so neither
                                                                    // motion nor standstill is shown
    }
    if (const auto hindered = hinderedEntry(state.robotMode, state.safetyMode)) {
        return *hindered;
    }
    if (!stepLabel.isEmpty()) {
        return {state.moving ? LaneKind::Moving : LaneKind::Idle, stepLabel};
    }
    if (state.freedriveActive) {
        return {LaneKind::Moving, StateLaneText::tr("Freedrive")};
    }
    if (state.moving && state.jogActive) {
        return {LaneKind::Moving,
                jogLabel.isEmpty() ? StateLaneText::tr("Jog") : StateLaneText::tr("Jog %1").arg(jogLabel)};
    }
    return motionEntry(state.moving);
}

}  // namespace tiller
