// SPDX-License-Identifier: MIT
#include "robot/station/text/mode_words.h"

#include <QCoreApplication>
#include <array>

namespace tiller {
namespace {

template <class Mode>
struct Row {
    Mode mode;
    const char* text;
    const char* advice;
};

/// Translation context of this file for lupdate.
struct ModeWordsText {
    Q_DECLARE_TR_FUNCTIONS(ModeWords)
};

template <class Mode, std::size_t N>
const Row<Mode>* rowOf(const std::array<Row<Mode>, N>& table, Mode mode) {
    for (const Row<Mode>& row : table) {
        if (row.mode == mode) {
            return &row;
        }
    }
    return nullptr;
}

constexpr auto kRobotModes = std::to_array<Row<RobotMode>>({
    {RobotMode::NoController, QT_TRANSLATE_NOOP("ModeWords", "No controller"),
     QT_TRANSLATE_NOOP("ModeWords", "The robot's controller is not running. Restart the control box.")},
    {RobotMode::Disconnected, QT_TRANSLATE_NOOP("ModeWords", "Arm disconnected"),
     QT_TRANSLATE_NOOP("ModeWords",
                       "The controller has no connection to the arm. See the teach pendant for the cause.")},
    {RobotMode::ConfirmSafety, QT_TRANSLATE_NOOP("ModeWords", "Confirm safety"),
     QT_TRANSLATE_NOOP("ModeWords", "Confirm the safety configuration on the teach pendant.")},
    {RobotMode::Booting, QT_TRANSLATE_NOOP("ModeWords", "Booting"),
     QT_TRANSLATE_NOOP("ModeWords", "The arm is starting. Wait a few seconds.")},
    {RobotMode::PowerOff, QT_TRANSLATE_NOOP("ModeWords", "Power off"),
     QT_TRANSLATE_NOOP("ModeWords", "The arm is powered off. Power on the arm.")},
    {RobotMode::PowerOn, QT_TRANSLATE_NOOP("ModeWords", "Power on"),
     QT_TRANSLATE_NOOP("ModeWords", "The arm is powered on and initializing. Wait a moment.")},
    {RobotMode::Idle, QT_TRANSLATE_NOOP("ModeWords", "Idle"),
     QT_TRANSLATE_NOOP("ModeWords", "The brakes are engaged. Release the brakes.")},
    {RobotMode::Backdrive, QT_TRANSLATE_NOOP("ModeWords", "Backdrive"),
     QT_TRANSLATE_NOOP(
         "ModeWords",
         "The arm is being moved by hand with its brakes released. Release the Freedrive button.")},
    {RobotMode::Running, QT_TRANSLATE_NOOP("ModeWords", "Running"),
     QT_TRANSLATE_NOOP("ModeWords", "The brakes are released. The arm is at standstill.")},
    {RobotMode::UpdatingFirmware, QT_TRANSLATE_NOOP("ModeWords", "Updating firmware"),
     QT_TRANSLATE_NOOP(
         "ModeWords",
         "The joints' firmware is being updated. Do not switch off the power until the update is complete.")},
});

constexpr auto kSafety = std::to_array<Row<SafetyStatus>>({
    {SafetyMode::Normal, QT_TRANSLATE_NOOP("ModeWords", "Normal"),
     QT_TRANSLATE_NOOP("ModeWords", "No safety stop is active.")},
    {SafetyMode::Reduced, QT_TRANSLATE_NOOP("ModeWords", "Reduced"),
     QT_TRANSLATE_NOOP("ModeWords", "The reduced safety limits are active.")},
    {SafetyMode::ProtectiveStop, QT_TRANSLATE_NOOP("ModeWords", "Protective stop"),
     QT_TRANSLATE_NOOP(
         "ModeWords",
         "The controller stopped the arm. Find the cause, wait 5 s, then unlock the protective stop.")},
    {SafetyMode::Recovery, QT_TRANSLATE_NOOP("ModeWords", "Recovery"),
     QT_TRANSLATE_NOOP(
         "ModeWords",
         "The arm is outside a safety limit. Use the teach pendant to move the arm back within the limits.")},
    {SafetyMode::SafeguardStop, QT_TRANSLATE_NOOP("ModeWords", "Safeguard stop"),
     QT_TRANSLATE_NOOP(
         "ModeWords",
         "A safeguard is open. Close it and, if a reset is configured, press the reset button.")},
    {SafetyMode::SystemEmergencyStop, QT_TRANSLATE_NOOP("ModeWords", "System emergency stop"),
     QT_TRANSLATE_NOOP(
         "ModeWords",
         "The cell's emergency stop is pressed. Release it, then power on the arm and release the brakes.")},
    {SafetyMode::RobotEmergencyStop, QT_TRANSLATE_NOOP("ModeWords", "Emergency stop"),
     QT_TRANSLATE_NOOP("ModeWords",
                       "The emergency stop button of the robot is pressed. Twist it clockwise to release it, "
                       "then power on the arm and release the brakes.")},
    {SafetyMode::Violation, QT_TRANSLATE_NOOP("ModeWords", "Safety violation"),
     QT_TRANSLATE_NOOP(
         "ModeWords",
         "A safety limit was exceeded and power was cut. Check the cause, then restart the safety "
         "system.")},
    {SafetyMode::Fault, QT_TRANSLATE_NOOP("ModeWords", "Safety fault"),
     QT_TRANSLATE_NOOP(
         "ModeWords",
         "The safety system found a fault. Check the robot's log, then restart the safety system.")},
    {SafetyMode::ValidateJointId, QT_TRANSLATE_NOOP("ModeWords", "Validate joints"),
     QT_TRANSLATE_NOOP("ModeWords", "A joint was replaced. Validate the joints on the teach pendant.")},
    {SafetyMode::Undefined, QT_TRANSLATE_NOOP("ModeWords", "Undefined"),
     QT_TRANSLATE_NOOP("ModeWords",
                       "The controller does not report its safety mode. Check the teach pendant.")},
    {SafetyMode::AutomaticModeSafeguardStop, QT_TRANSLATE_NOOP("ModeWords", "Automatic safeguard stop"),
     QT_TRANSLATE_NOOP("ModeWords",
                       "The automatic mode safeguard is open. Close it, or switch to manual mode.")},
    {SafetyMode::SystemThreePositionEnablingStop, QT_TRANSLATE_NOOP("ModeWords", "Enabling device stop"),
     QT_TRANSLATE_NOOP("ModeWords", "The enabling device is not held. Hold it in its middle position.")},
    {SafetyMode::TpThreePositionEnablingStop, QT_TRANSLATE_NOOP("ModeWords", "Pendant enabling stop"),
     QT_TRANSLATE_NOOP(
         "ModeWords",
         "The enabling button of the teach pendant is not held. Hold it in its middle position.")},
    {SafetyMode::ImmiEmergencyStop, QT_TRANSLATE_NOOP("ModeWords", "IMMI emergency stop"),
     QT_TRANSLATE_NOOP(
         "ModeWords",
         "The moulding machine's emergency stop is pressed. Release it, then power on the arm and "
         "release the brakes.")},
    {SafetyMode::ImmiSafeguardStop, QT_TRANSLATE_NOOP("ModeWords", "IMMI safeguard stop"),
     QT_TRANSLATE_NOOP("ModeWords", "The moulding machine's safeguard is open. Close it.")},
    {SafetyMode::ProfisafeWaitingForParameters, QT_TRANSLATE_NOOP("ModeWords", "PROFIsafe waiting"),
     QT_TRANSLATE_NOOP("ModeWords",
                       "The robot is waiting for the PROFIsafe controller. Check the fieldbus and the "
                       "PROFIsafe parameters.")},
    {SafetyMode::ProfisafeAutomaticModeSafeguardStop,
     QT_TRANSLATE_NOOP("ModeWords", "PROFIsafe automatic stop"),
     QT_TRANSLATE_NOOP("ModeWords",
                       "The PROFIsafe controller requests an automatic mode safeguard stop. Clear the "
                       "request on that controller.")},
    {SafetyMode::ProfisafeSafeguardStop, QT_TRANSLATE_NOOP("ModeWords", "PROFIsafe safeguard stop"),
     QT_TRANSLATE_NOOP(
         "ModeWords",
         "The PROFIsafe controller requests a safeguard stop. Clear the request on that controller.")},
    {SafetyMode::ProfisafeEmergencyStop, QT_TRANSLATE_NOOP("ModeWords", "PROFIsafe emergency stop"),
     QT_TRANSLATE_NOOP("ModeWords",
                       "The PROFIsafe controller requests an emergency stop. Clear the request on that "
                       "controller, then power on the arm and release the brakes.")},
    {SafetyMode::SafetyApiSafeguardStop, QT_TRANSLATE_NOOP("ModeWords", "Safety API stop"),
     QT_TRANSLATE_NOOP(
         "ModeWords",
         "A program requests a safeguard stop through the safety API. Clear the request in that program.")},
    {kIoPlaneStop, QT_TRANSLATE_NOOP("ModeWords", "I/O plane stop"),
     QT_TRANSLATE_NOOP("ModeWords",
                       "The tool crossed a safety plane that is enabled by an input. Move the tool back with "
                       "the teach pendant, or turn the input off.")},
});

constexpr auto kRuntime = std::to_array<Row<RuntimeState>>({
    {RuntimeState::Stopping, QT_TRANSLATE_NOOP("ModeWords", "Program stopping"),
     QT_TRANSLATE_NOOP("ModeWords", "The program on the robot is stopping.")},
    {RuntimeState::Stopped, QT_TRANSLATE_NOOP("ModeWords", "No program"),
     QT_TRANSLATE_NOOP("ModeWords", "No program is running on the robot.")},
    {RuntimeState::Playing, QT_TRANSLATE_NOOP("ModeWords", "Program running"),
     QT_TRANSLATE_NOOP("ModeWords", "A program is running on the robot and may move the arm.")},
    {RuntimeState::Pausing, QT_TRANSLATE_NOOP("ModeWords", "Program pausing"),
     QT_TRANSLATE_NOOP("ModeWords", "The program is pausing.")},
    {RuntimeState::Paused, QT_TRANSLATE_NOOP("ModeWords", "Program paused"),
     QT_TRANSLATE_NOOP(
         "ModeWords", "Press “Play” to continue the interrupted motion, or stop the program to discard it.")},
    {RuntimeState::Resuming, QT_TRANSLATE_NOOP("ModeWords", "Program resuming"),
     QT_TRANSLATE_NOOP("ModeWords", "The program is resuming, and the arm may move.")},
});

}  // namespace

ModeWords robotModeWords(RobotMode mode) {
    if (const auto* row = rowOf(kRobotModes, mode)) {
        return {ModeWordsText::tr(row->text), ModeWordsText::tr(row->advice)};
    }
    return {robotModeName(mode),
            ModeWordsText::tr("Unknown robot mode %1. See the teach pendant.").arg(static_cast<int>(mode))};
}

ModeWords safetyWords(SafetyStatus status) {
    if (const auto* row = rowOf(kSafety, status)) {
        return {ModeWordsText::tr(row->text), ModeWordsText::tr(row->advice)};
    }
    return {
        safetyModeName(status),
        ModeWordsText::tr("Unknown safety mode %1. See the teach pendant.").arg(static_cast<int>(status))};
}

ModeWords runtimeWords(RuntimeState state) {
    if (const auto* row = rowOf(kRuntime, state)) {
        return {ModeWordsText::tr(row->text), ModeWordsText::tr(row->advice)};
    }
    return {
        runtimeStateName(state),
        ModeWordsText::tr("Unknown program state %1. See the teach pendant.").arg(static_cast<int>(state))};
}

SafetyStatus shownSafety(SafetyMode mode, SafetyStatus status) {
    if (status == SafetyMode::Undefined) {
        return mode;  // before 3.10 and 5.4, `status` is not available
    }
    return allowsMotion(status) && !allowsMotion(mode) ? mode : status;
}

}  // namespace tiller
