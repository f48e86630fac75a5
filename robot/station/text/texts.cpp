// SPDX-License-Identifier: MIT
#include "robot/station/text/texts.h"

#include <QCoreApplication>

#include "robot/station/text/error_summary.h"
#include "robot/station/text/mode_words.h"

namespace tiller::texts {
namespace {

/// Translation context of this file for lupdate.
struct TextsText {
    Q_DECLARE_TR_FUNCTIONS(Texts)
};

/// Suggested action; empty if the error text is sufficient.
QString advice(ErrorCode code) {
    switch (code) {
        case ErrorCode::AddressInvalid:
            return TextsText::tr("Enter an IP address, such as 192.168.0.10, or a host name.");
        case ErrorCode::HostUnreachable:
            return TextsText::tr(
                "Check that the robot is switched on, the cable is plugged in, and this PC is on the same "
                "network.");
        case ErrorCode::ConnectionRefused:
            return TextsText::tr(
                "Enable the interface on the robot under Settings > Security > Services. A robot that has "
                "just started may need another minute.");
        case ErrorCode::ConnectionClosed:
            return TextsText::tr(
                "The robot may be restarting or switching between Local and Remote control. Wait a minute, "
                "then connect again.");
        case ErrorCode::Timeout:
            return TextsText::tr("The robot does not respond. Check the cable and the address.");
        case ErrorCode::LinkLost:
            return TextsText::tr(
                "No more data received. Check the cable. Tiller reconnects automatically; motion does not "
                "resume.");
        case ErrorCode::ProtocolError:
            return TextsText::tr(
                "The response is not valid for this protocol. Check the address and the port.");
        case ErrorCode::VersionUnsupported:
            return TextsText::tr("If newer software is available for this robot, update the robot.");
        case ErrorCode::FieldUnknown:
            return TextsText::tr("The robot's software does not provide this value.");
        case ErrorCode::RegisterInUse:
            return TextsText::tr(
                "Another program or a fieldbus on the robot uses these registers. Close the other program, "
                "or disable the fieldbus in the installation.");
        case ErrorCode::NotConnected:
            return TextsText::tr("Connect to a robot first.");
        case ErrorCode::NotInControl:
            return TextsText::tr("Take control first.");
        case ErrorCode::UnsafeState:
            return TextsText::tr("Power on the arm, release the brakes and clear any safety stop first.");
        case ErrorCode::RemoteControlRequired:
            return TextsText::tr("Switch the robot to Remote control at the top right of the teach pendant.");
        case ErrorCode::LimitExceeded:
            return TextsText::tr(
                "Choose a target within the reach of the arm and a speed below the speed cap.");
        case ErrorCode::NoSolution:
            return TextsText::tr(
                "The arm cannot reach this pose. Move the target closer or rotate the tool.");
        case ErrorCode::ScriptError:
            return TextsText::tr(
                "The robot could not run the program. See the log for the controller's message.");
        case ErrorCode::FileNotReadable:
            return TextsText::tr("Check that the file exists and that you have permission to read it.");
        case ErrorCode::FileNotWritable:
            return TextsText::tr("Choose a folder that you have permission to write to.");
        case ErrorCode::FileCorrupt:
            return TextsText::tr(
                "The file was not changed. Open a backup, or repair the file at the reported position.");
        case ErrorCode::DiskFull:
            return TextsText::tr("Free some space on the disk, then save or record again.");
        case ErrorCode::None:
        case ErrorCode::Cancelled:
        case ErrorCode::Stopped:
        case ErrorCode::Rejected:
        case ErrorCode::InvalidArgument:
        case ErrorCode::Internal:
            return {};
    }
    return {};
}

QString happening(ErrorCode code) {
    switch (code) {
        case ErrorCode::None:
            return TextsText::tr("Done");
        case ErrorCode::AddressInvalid:
            return TextsText::tr("Address not found");
        case ErrorCode::HostUnreachable:
            return TextsText::tr("Robot not reachable");
        case ErrorCode::ConnectionRefused:
            return TextsText::tr("Connection refused");
        case ErrorCode::ConnectionClosed:
            return TextsText::tr("Connection closed by the robot");
        case ErrorCode::Timeout:
            return TextsText::tr("Timed out");
        case ErrorCode::Cancelled:
            return TextsText::tr("Cancelled");
        case ErrorCode::LinkLost:
            return TextsText::tr("Connection lost");
        case ErrorCode::ProtocolError:
            return TextsText::tr("Protocol error");
        case ErrorCode::VersionUnsupported:
            return TextsText::tr("Not supported by this robot");
        case ErrorCode::FieldUnknown:
            return TextsText::tr("Value not available");
        case ErrorCode::RegisterInUse:
            return TextsText::tr("Registers in use");
        case ErrorCode::NotConnected:
            return TextsText::tr("Not connected");
        case ErrorCode::NotInControl:
            return TextsText::tr("Not in control");
        case ErrorCode::UnsafeState:
            return TextsText::tr("Robot not ready");
        case ErrorCode::RemoteControlRequired:
            return TextsText::tr("Robot is in Local control");
        case ErrorCode::LimitExceeded:
            return TextsText::tr("Outside the limits");
        case ErrorCode::InvalidArgument:
            return TextsText::tr("Invalid value");
        case ErrorCode::NoSolution:
            return TextsText::tr("Out of reach");
        case ErrorCode::Stopped:
            return TextsText::tr("Stopped");
        case ErrorCode::Rejected:
            return TextsText::tr("Refused by the robot");
        case ErrorCode::ScriptError:
            return TextsText::tr("Program error on the robot");
        case ErrorCode::FileNotReadable:
            return TextsText::tr("Cannot read the file");
        case ErrorCode::FileNotWritable:
            return TextsText::tr("Cannot write the file");
        case ErrorCode::FileCorrupt:
            return TextsText::tr("File is damaged");
        case ErrorCode::DiskFull:
            return TextsText::tr("Disk full");
        case ErrorCode::Internal:
            return TextsText::tr("Internal error");
    }
    return TextsText::tr("Internal error");
}

}  // namespace

QString errorText(const Error& error) {
    if (error.context.endsWith(QLatin1Char('.')) && error.controllerMessage.isEmpty()) {
        return error.context;  // already a complete sentence
    }
    QString text = happening(error.code);
    if (!error.context.isEmpty()) {
        text += QStringLiteral(": ") + error.context;
    }
    if (!error.controllerMessage.isEmpty()) {
        text += QStringLiteral(" (") + error.controllerMessage + QLatin1Char(')');
    }
    text += QLatin1Char('.');
    const QString todo = advice(error.code);
    return todo.isEmpty() ? text : text + QLatin1Char(' ') + todo;
}

QString errorSummary(const Error& error) {
    const bool isForOperator = error.code == ErrorCode::ScriptError ||
                               error.context.endsWith(QLatin1Char('.')) || advice(error.code).isEmpty();
    return errorText(isForOperator ? error : Error{error.code, {}, {}});
}

QString stopCauseText(control::StopCause cause) {
    using control::StopCause;
    switch (cause) {
        case StopCause::None:
            return TextsText::tr("ended");
        case StopCause::Released:
            return TextsText::tr("button or key released");
        case StopCause::PointerLeft:
            return TextsText::tr("pointer left the button");
        case StopCause::FocusLost:
            return TextsText::tr("focus lost");
        case StopCause::WindowDeactivated:
            return TextsText::tr("another window became active");
        case StopCause::WindowClosed:
            return TextsText::tr("window closed");
        case StopCause::DialogOpened:
            return TextsText::tr("a dialog or menu opened");
        case StopCause::SelectionChanged:
            return TextsText::tr("selection or modifier key changed");
        case StopCause::SecondButton:
            return TextsText::tr("another button or key pressed");
        case StopCause::Escape:
            return TextsText::tr("Esc pressed");
        case StopCause::Space:
            return TextsText::tr("Space pressed");
        case StopCause::StopButton:
            return TextsText::tr("STOP pressed");
        case StopCause::DeviceLost:
            return TextsText::tr("input device lost");
        case StopCause::DataStale:
            return TextsText::tr("robot data arrived too late");
        case StopCause::UnsafeMode:
            return TextsText::tr("robot or safety mode changed");
        case StopCause::EventLoopStalled:
            return TextsText::tr("the window did not respond");
        case StopCause::Sleep:
            return TextsText::tr("the PC is going to sleep");
        case StopCause::LinkLost:
            return TextsText::tr("connection lost");
        case StopCause::LimitReached:
            return TextsText::tr("limit reached");
        case StopCause::ControlLost:
            return TextsText::tr("control lost");
        case StopCause::Completed:
            return TextsText::tr("target reached");
        case StopCause::ApiCall:
            return TextsText::tr("stopped by a program");
        case StopCause::Contact:
            return TextsText::tr("contact detected");
        case StopCause::Unreachable:
            return TextsText::tr("target cannot be reached");
        case StopCause::TargetTooFar:
            return TextsText::tr("servo target too far from the previous target");
        case StopCause::HoldUnproven:
            return TextsText::tr("could not verify that the button or key is still pressed");
        case StopCause::HeldTooLong:
            return TextsText::tr("maximum hold time reached; press again");
        default:
            return TextsText::tr("ended");
    }
}

QString unmeasuredText(control::UnmeasuredStop::Reason reason) {
    using Reason = control::UnmeasuredStop::Reason;
    switch (reason) {
        case Reason::OtherProgram:
            return TextsText::tr("not measured: another program is moving the arm");
        case Reason::NotStopped:
            return TextsText::tr("the robot did not receive the stop command");
        case Reason::DataGap:
            break;
    }
    return TextsText::tr("not measured: no data during the stop");
}

QString robotModeObstacle(RobotMode mode) {
    return mode == RobotMode::Running ? QString() : robotModeWords(mode).advice;
}

QString safetyModeObstacle(SafetyMode mode) {
    if (allowsMotion(mode)) {
        return {};
    }
    const ModeWords words = safetyWords(mode);
    return words.text + QStringLiteral(". ") + words.advice;
}

QString monitorOnlyObstacle() {
    return TextsText::tr(
        "Monitor only: this window does not change anything on the robot. Turn off “Monitor only” in "
        "Settings, or start Tiller without --monitor-only.");
}

QString remoteObstacle() {
    return errorText({ErrorCode::RemoteControlRequired, {}, {}});
}

QString controlLossText(control::ControlLoss loss) {
    using control::ControlLoss;
    switch (loss) {
        case ControlLoss::None:
            return {};
        case ControlLoss::NotTaken:
            return TextsText::tr("Monitoring. Take control to move the arm.");
        case ControlLoss::Taking:
            return TextsText::tr("Taking control…");
        case ControlLoss::Released:
            return TextsText::tr("Control was given back. Take control to move the arm.");
        case ControlLoss::ScriptStopped:
            return TextsText::tr("The control program on the robot was stopped. Take control again.");
        case ControlLoss::EchoStalled:
            return TextsText::tr("The control program was replaced or does not respond. Take control again.");
        case ControlLoss::LinkLost:
            return TextsText::tr("The connection was lost. Take control again.");
        case ControlLoss::DataStale:
            return TextsText::tr(
                "No current data from the robot. Check the network connection to the robot.");
        case ControlLoss::OwnScript:
            return TextsText::tr("Your script is running. Tiller regains control when the script ends.");
    }
    return {};
}

}  // namespace tiller::texts
