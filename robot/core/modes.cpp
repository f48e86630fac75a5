// SPDX-License-Identifier: MIT
#include "robot/core/modes.h"

#include <array>
#include <utility>

#include "robot/core/mode_lists.h"

namespace tiller {
namespace {

constexpr auto kRobotModes = std::to_array<std::pair<RobotMode, const char*>>({
    {RobotMode::NoController, "NO_CONTROLLER"},
    {RobotMode::Disconnected, "DISCONNECTED"},
    {RobotMode::ConfirmSafety, "CONFIRM_SAFETY"},
    {RobotMode::Booting, "BOOTING"},
    {RobotMode::PowerOff, "POWER_OFF"},
    {RobotMode::PowerOn, "POWER_ON"},
    {RobotMode::Idle, "IDLE"},
    {RobotMode::Backdrive, "BACKDRIVE"},
    {RobotMode::Running, "RUNNING"},
    {RobotMode::UpdatingFirmware, "UPDATING_FIRMWARE"},
});

constexpr auto kSafetyModes = std::to_array<std::pair<SafetyMode, const char*>>({
    {SafetyMode::Normal, "NORMAL"},
    {SafetyMode::Reduced, "REDUCED"},
    {SafetyMode::ProtectiveStop, "PROTECTIVE_STOP"},
    {SafetyMode::Recovery, "RECOVERY"},
    {SafetyMode::SafeguardStop, "SAFEGUARD_STOP"},
    {SafetyMode::SystemEmergencyStop, "SYSTEM_EMERGENCY_STOP"},
    {SafetyMode::RobotEmergencyStop, "ROBOT_EMERGENCY_STOP"},
    {SafetyMode::Violation, "VIOLATION"},
    {SafetyMode::Fault, "FAULT"},
    {SafetyMode::ValidateJointId, "VALIDATE_JOINT_ID"},
    {SafetyMode::Undefined, "UNDEFINED_SAFETY_MODE"},
    {SafetyMode::AutomaticModeSafeguardStop, "AUTOMATIC_MODE_SAFEGUARD_STOP"},
    {SafetyMode::SystemThreePositionEnablingStop, "SYSTEM_THREE_POSITION_ENABLING_STOP"},
    {SafetyMode::TpThreePositionEnablingStop, "TP_THREE_POSITION_ENABLING_STOP"},
    {SafetyMode::ImmiEmergencyStop, "IMMI_EMERGENCY_STOP"},
    {SafetyMode::ImmiSafeguardStop, "IMMI_SAFEGUARD_STOP"},
    {SafetyMode::ProfisafeWaitingForParameters, "PROFISAFE_WAITING_FOR_PARAMETERS"},
    {SafetyMode::ProfisafeAutomaticModeSafeguardStop, "PROFISAFE_AUTOMATIC_MODE_SAFEGUARD_STOP"},
    {SafetyMode::ProfisafeSafeguardStop, "PROFISAFE_SAFEGUARD_STOP"},
    {SafetyMode::ProfisafeEmergencyStop, "PROFISAFE_EMERGENCY_STOP"},
    {SafetyMode::SafetyApiSafeguardStop, "SAFETY_API_SAFEGUARD_STOP"},
    {kIoPlaneStop, "IO_PLANE_STOP"},
});

constexpr auto kRuntimeStates = std::to_array<std::pair<RuntimeState, const char*>>({
    {RuntimeState::Stopping, "STOPPING"},
    {RuntimeState::Stopped, "STOPPED"},
    {RuntimeState::Playing, "PLAYING"},
    {RuntimeState::Pausing, "PAUSING"},
    {RuntimeState::Paused, "PAUSED"},
    {RuntimeState::Resuming, "RESUMING"},
});

constexpr auto kJointModes = std::to_array<std::pair<JointMode, const char*>>({
    {JointMode::Backdrive, "BACKDRIVE"},
    {JointMode::PowerOff, "POWER_OFF"},
    {JointMode::Booting, "BOOTING"},
    {JointMode::Running, "RUNNING"},
    {JointMode::Idle, "IDLE"},
});

template <class Mode, std::size_t N>
QString nameIn(const std::array<std::pair<Mode, const char*>, N>& names, Mode mode) {
    for (const auto& [value, name] : names) {
        if (value == mode) {
            return QString::fromLatin1(name);
        }
    }
    return QStringLiteral("UNKNOWN_%1").arg(static_cast<qint64>(mode));
}

template <class Mode, std::size_t N>
std::vector<Mode> valuesOf(const std::array<std::pair<Mode, const char*>, N>& names) {
    std::vector<Mode> values;
    values.reserve(names.size());
    for (const auto& [value, name] : names) {
        values.push_back(value);
    }
    return values;
}

}  // namespace

QString robotModeName(RobotMode mode) {
    return nameIn(kRobotModes, mode);
}

QString safetyModeName(SafetyMode mode) {
    return nameIn(kSafetyModes, mode);
}

QString runtimeStateName(RuntimeState state) {
    return nameIn(kRuntimeStates, state);
}

QString jointModeName(JointMode mode) {
    return nameIn(kJointModes, mode);
}

std::vector<RobotMode> robotModes() {
    return valuesOf(kRobotModes);
}

std::vector<SafetyStatus> safetyStatuses() {
    return valuesOf(kSafetyModes);
}

std::vector<RuntimeState> runtimeStates() {
    return valuesOf(kRuntimeStates);
}

}  // namespace tiller
