// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/lane_text.h"

#include <QCoreApplication>

namespace tiller {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("tiller::StateLane", text);
}

QString safetyWord(SafetyMode mode) {
    switch (mode) {
        case SafetyMode::ProtectiveStop:
            return tr("Protective stop");
        case SafetyMode::Recovery:
            return tr("Recovery");
        case SafetyMode::SafeguardStop:
        case SafetyMode::AutomaticModeSafeguardStop:
        case SafetyMode::ImmiSafeguardStop:
        case SafetyMode::ProfisafeSafeguardStop:
        case SafetyMode::ProfisafeAutomaticModeSafeguardStop:
        case SafetyMode::SafetyApiSafeguardStop:
            return tr("Safeguard stop");
        case SafetyMode::SystemEmergencyStop:
        case SafetyMode::RobotEmergencyStop:
        case SafetyMode::ImmiEmergencyStop:
        case SafetyMode::ProfisafeEmergencyStop:
            return tr("Emergency stop");
        case SafetyMode::SystemThreePositionEnablingStop:
        case SafetyMode::TpThreePositionEnablingStop:
            return tr("Enabling device released");
        case SafetyMode::Violation:
            return tr("Safety violation");
        case SafetyMode::Fault:
            return tr("Safety fault");
        default:
            return tr("Stopped");
    }
}

QString robotModeWord(RobotMode mode) {
    switch (mode) {
        case RobotMode::PowerOff:
            return tr("Power off");
        case RobotMode::Booting:
        case RobotMode::PowerOn:
            return tr("Starting");
        case RobotMode::Idle:
            return tr("Brakes on");
        case RobotMode::Backdrive:
            return tr("Backdrive");
        default:
            return tr("Not running");
    }
}

}  // namespace

LaneEntry laneEntry(const SessionState& state, const QString& jogLabel) {
    if (!state.hasData()) {
        return {LaneKind::NoData, tr("No data")};
    }
    if (!allowsMotion(state.safetyMode) && state.safetyMode != SafetyMode::Undefined) {
        return {LaneKind::Stopped, safetyWord(state.safetyMode)};
    }
    if (state.robotMode != RobotMode::Running) {
        return {LaneKind::Off, robotModeWord(state.robotMode)};
    }
    if (state.moving && state.jogActive) {
        return {LaneKind::Moving, jogLabel.isEmpty() ? tr("Jog") : tr("Jog %1").arg(jogLabel)};
    }
    return state.moving ? LaneEntry{LaneKind::Moving, tr("Moving")} : LaneEntry{LaneKind::Idle, tr("Idle")};
}

}  // namespace tiller
