// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/session/texts.h"

#include <QCoreApplication>

#include "widgets/session/mode_words.h"
#include "widgets/session/session_state.h"

namespace tiller::texts {
namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("Texts", text);
}

/// What to do about it; empty where the happening explains itself.
QString advice(ErrorCode code) {
    switch (code) {
        case ErrorCode::AddressInvalid:
            return tr("Check the address: four numbers as in 192.168.0.10, or a name the network knows.");
        case ErrorCode::HostUnreachable:
            return tr(
                "Check that the robot is switched on, the cable is plugged in, and this PC is in the same "
                "network.");
        case ErrorCode::ConnectionRefused:
            return tr(
                "Switch the interface on at the robot: Settings, Security, Services. A robot that has just "
                "been "
                "started may need another minute.");
        case ErrorCode::ConnectionClosed:
            return tr(
                "The robot ended the connection: it may be restarting, or was switched between Local and "
                "Remote.");
        case ErrorCode::Timeout:
            return tr("The robot does not answer. Check the cable and that the address is the robot's own.");
        case ErrorCode::LinkLost:
            return tr(
                "Data stopped coming. Check the cable; the connection comes back by itself, motion does "
                "not.");
        case ErrorCode::ProtocolError:
            return tr("What answers there does not speak RTDE as it should. Check address and port.");
        case ErrorCode::VersionUnsupported:
            return tr("The robot's software is too old for this.");
        case ErrorCode::FieldUnknown:
            return tr("The robot's software does not have this value.");
        case ErrorCode::RegisterInUse:
            return tr(
                "Another program or a fieldbus on the robot owns these registers: close the other program, "
                "or switch "
                "the fieldbus off in the installation.");
        case ErrorCode::NotConnected:
            return tr("Connect to a robot first.");
        case ErrorCode::NotInControl:
            return tr("Take control first.");
        case ErrorCode::UnsafeState:
            return tr("Bring the robot to Running and its safety to Normal first.");
        case ErrorCode::RemoteControlRequired:
            return tr("Switch the robot to Remote control on the teach pendant, at the top right.");
        case ErrorCode::LimitExceeded:
            return tr("Choose a target inside the arm's range and a speed within the cap.");
        case ErrorCode::NoSolution:
            return tr("The arm cannot reach this pose: move the point nearer or turn the tool.");
        case ErrorCode::ScriptError:
            return tr("The robot could not run the program it was sent. See the log for its own words.");
        case ErrorCode::FileNotReadable:
            return tr("Check that the file exists and may be read.");
        case ErrorCode::FileNotWritable:
            return tr("Choose a folder you may write to.");
        case ErrorCode::FileCorrupt:
            return tr("The file was left as it is. Open a backup, or repair the named place.");
        case ErrorCode::DiskFull:
            return tr("The disk is full: what was recorded so far is kept. Free some space and record anew.");
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
            return tr("Done");
        case ErrorCode::AddressInvalid:
            return tr("Address not found");
        case ErrorCode::HostUnreachable:
            return tr("Robot not reachable");
        case ErrorCode::ConnectionRefused:
            return tr("Connection refused");
        case ErrorCode::ConnectionClosed:
            return tr("Connection ended by the robot");
        case ErrorCode::Timeout:
            return tr("No answer in time");
        case ErrorCode::Cancelled:
            return tr("Cancelled");
        case ErrorCode::LinkLost:
            return tr("Link lost");
        case ErrorCode::ProtocolError:
            return tr("Not understood");
        case ErrorCode::VersionUnsupported:
            return tr("Not supported by this robot");
        case ErrorCode::FieldUnknown:
            return tr("Value not available");
        case ErrorCode::RegisterInUse:
            return tr("Registers in use");
        case ErrorCode::NotConnected:
            return tr("Not connected");
        case ErrorCode::NotInControl:
            return tr("Not in control");
        case ErrorCode::UnsafeState:
            return tr("Not possible in this state");
        case ErrorCode::RemoteControlRequired:
            return tr("Robot is in Local control");
        case ErrorCode::LimitExceeded:
            return tr("Outside the limits");
        case ErrorCode::InvalidArgument:
            return tr("Not a valid value");
        case ErrorCode::NoSolution:
            return tr("Out of reach");
        case ErrorCode::Stopped:
            return tr("Stopped");
        case ErrorCode::Rejected:
            return tr("Refused by the robot");
        case ErrorCode::ScriptError:
            return tr("Program error on the robot");
        case ErrorCode::FileNotReadable:
            return tr("File cannot be read");
        case ErrorCode::FileNotWritable:
            return tr("File cannot be written");
        case ErrorCode::FileCorrupt:
            return tr("File is damaged");
        case ErrorCode::DiskFull:
            return tr("Disk full");
        case ErrorCode::Internal:
            return tr("Internal error");
    }
    return tr("Internal error");
}

}  // namespace

QString errorText(const Error& error) {
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

QString stopCauseText(control::StopCause cause) {
    using control::StopCause;
    switch (cause) {
        case StopCause::None:
            return tr("ended");
        case StopCause::Released:
            return tr("released");
        case StopCause::PointerLeft:
            return tr("pointer left the key");
        case StopCause::FocusLost:
            return tr("focus lost");
        case StopCause::WindowDeactivated:
            return tr("window no longer active");
        case StopCause::WindowClosed:
            return tr("window closed");
        case StopCause::DialogOpened:
            return tr("a dialog or menu opened");
        case StopCause::SelectionChanged:
            return tr("selection changed");
        case StopCause::SecondButton:
            return tr("second button");
        case StopCause::Escape:
            return tr("Esc");
        case StopCause::Space:
            return tr("Space");
        case StopCause::StopButton:
            return tr("STOP");
        case StopCause::DeviceLost:
            return tr("input device lost");
        case StopCause::DataStale:
            return tr("robot data too old");
        case StopCause::UnsafeMode:
            return tr("robot or safety mode changed");
        case StopCause::EventLoopStalled:
            return tr("not refreshed in time");
        case StopCause::Sleep:
            return tr("PC going to sleep");
        case StopCause::LinkLost:
            return tr("link lost");
        case StopCause::LimitReached:
            return tr("limit reached");
        case StopCause::ControlLost:
            return tr("control lost");
        case StopCause::Completed:
            return tr("target reached");
        case StopCause::ApiCall:
            return tr("stopped by a program");
        case StopCause::Contact:
            return tr("contact");
        case StopCause::Unreachable:
            return tr("target cannot be reached");
        case StopCause::TargetTooFar:
            return tr("target too far away for one step");
        case StopCause::HoldUnproven:
            return tr("no sign that it was still held");
        case StopCause::HeldTooLong:
            return tr("held for the longest time; press again");
        default:
            return tr("ended");
    }
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

QString serviceObstacle(const SessionState& state) {
    const bool withoutApi = state.version.isPolyScopeX() && state.version < SoftwareVersion{10, 11, 0, 0} &&
                            state.service == dashboard::ServiceKind::Unknown;
    return withoutApi
               ? tr("PolyScope X before 10.11 takes no such commands over the network: use the tablet.")
               : QString();
}

QString serviceObstacle(const SessionState& state, dashboard::RobotCommand command) {
    return dashboard::offers(state.service, command)
               ? serviceObstacle(state)
               : tr("PolyScope X has no command for closing popups over the network: use the tablet.");
}

QString controlLossText(control::ControlLoss loss) {
    using control::ControlLoss;
    switch (loss) {
        case ControlLoss::None:
            return {};
        case ControlLoss::NotTaken:
            return tr("Only watching. Take control to move the arm.");
        case ControlLoss::Taking:
            return tr("Taking control…");
        case ControlLoss::Released:
            return tr("Control was given back. Take control to move the arm.");
        case ControlLoss::ScriptStopped:
            return tr("The control program was stopped on the robot. Take control again.");
        case ControlLoss::EchoStalled:
            return tr("The control program does not answer. Take control again.");
        case ControlLoss::LinkLost:
            return tr("The link was lost. Take control again.");
        case ControlLoss::OwnScript:
            return tr("A script of your own is running. Control comes back when it ends.");
    }
    return {};
}

}  // namespace tiller::texts
