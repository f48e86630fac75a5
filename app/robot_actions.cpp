// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robot_actions.h"

#include "app/action_table.h"
#include "robot/station/link/obstacles.h"
#include "robot/station/text/texts.h"

namespace tiller::app {
namespace {

QString needsLink(const SessionState& state) {
    return state.link == LinkState::Live ? QString() : RobotActions::tr("Connect to a robot first.");
}

QString needsNormalSafety(const SessionState& state) {
    const QString link = needsLink(state);
    return !link.isEmpty()                ? link
           : allowsMotion(state.safety()) ? QString()
                                          : safetyWords(state.safety()).advice;
}

/// Returns the reason why the command is not possible: no connection, or an obstacle of the service that
/// executes it. Empty if the command is possible.
QString needsService(const SessionState& state, RobotCommand command) {
    const QString link = needsLink(state);
    return link.isEmpty() ? serviceObstacle(state, command) : link;
}

/// Returns the reason why a command for programs on the robot is disabled.
QString needsForeignProgram(const SessionState& state, RobotCommand command, bool running) {
    if (const QString service = needsService(state, command); !service.isEmpty()) {
        return service;
    }
    if (state.control == ControlState::InControl) {
        return RobotActions::tr("Give control back first.");
    }
    const bool runs =
        state.runtimeState == RuntimeState::Playing || state.runtimeState == RuntimeState::Resuming;
    return runs == running ? QString()
           : running       ? RobotActions::tr("No program is running on the robot.")
                           : RobotActions::tr("A program is already running.");
}

}  // namespace

void RobotActions::addTo(ActionTable& table, RobotSession& session, const RobotActionHooks& hooks) {
    addConnection(table, session, hooks);
    addPower(table, session, hooks);
    addControl(table, session, hooks);
}

void RobotActions::addConnection(ActionTable& table, RobotSession& session, const RobotActionHooks& hooks) {
    table.add({"robot.connect", tr("Connect…"), tr("Select the simulator, a robot or a project."),
               QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C), hooks.askForRobot});
    table.add({"robot.simulator",
               tr("Simulated robot"),
               tr("Starts the simulated robot and connects to it."),
               {},
               hooks.connectSimulator});
    table.add({"robot.check",
               tr("Check the connection…"),
               tr("Checks the connection between this PC and the robot and suggests fixes."),
               {},
               [&session, check = hooks.check] {
                   const SessionState& state = session.state();
                   check({state.robotName, state.address, state.portOffset, state.simulated});
               },
               [](const SessionState& s) {
                   return s.link == LinkState::Disconnected ? tr("Select a robot first.") : QString();
               }});
    table.add({"robot.disconnect",
               tr("Disconnect"),
               tr("Stops Tiller's motion, then closes the connection."),
               {},
               hooks.disconnect,
               [](const SessionState& s) {
                   return s.link == LinkState::Disconnected ? tr("No robot is connected.") : QString();
               }});
}

void RobotActions::addPower(ActionTable& table, RobotSession& session, const RobotActionHooks& hooks) {
    const auto perform = [&session](RobotCommand command) {
        return [&session, command] { session.services().perform(command); };
    };
    table.add({"power.on",
               commandText(RobotCommand::PowerOn),
               tr("Powers on the arm. The brakes stay engaged."),
               {},
               perform(RobotCommand::PowerOn),
               [](const SessionState& s) {
                   const QString service = needsService(s, RobotCommand::PowerOn);
                   const QString why = service.isEmpty() ? needsNormalSafety(s) : service;
                   return !why.isEmpty() || s.robotMode == RobotMode::PowerOff
                              ? why
                              : tr("The arm is powered on or powering on.");
               }});
    table.add({"power.brakes",
               commandText(RobotCommand::ReleaseBrakes),
               tr("The arm may sag by a few millimetres. Keep clear."),
               {},
               perform(RobotCommand::ReleaseBrakes),
               [](const SessionState& s) {
                   const QString service = needsService(s, RobotCommand::ReleaseBrakes);
                   const QString why = service.isEmpty() ? needsNormalSafety(s) : service;
                   return !why.isEmpty() || s.robotMode == RobotMode::Idle
                              ? why
                              : robotModeWords(s.robotMode).advice;
               }});
    table.add({"power.off",
               commandText(RobotCommand::PowerOff),
               tr("Stops programs, engages the brakes and powers the arm off."),
               {},
               perform(RobotCommand::PowerOff),
               [](const SessionState& s) {
                   const QString why = needsService(s, RobotCommand::PowerOff);
                   return !why.isEmpty() || s.robotMode != RobotMode::PowerOff
                              ? why
                              : tr("The arm is powered off.");
               }});
    table.add({"power.recover",
               tr("Recover…"),
               tr("Shows the cause of the stop and the recovery steps."),
               {},
               hooks.showRecovery,
               [](const SessionState& s) {
                   const QString why = needsLink(s);
                   return !why.isEmpty() || !allowsMotion(s.safety())
                              ? why
                              : tr("The safety system reports no stop.");
               }});
    table.add({"power.restartSafety",
               commandText(RobotCommand::RestartSafety),
               tr("Resets the safety system after a violation or fault. The arm stays powered off."),
               {},
               // The page requires the user to inspect the arm first.
               hooks.showRecovery,
               [](const SessionState& s) {
                   const QString why = needsService(s, RobotCommand::RestartSafety);
                   const bool needed = s.safety() == SafetyMode::Violation || s.safety() == SafetyMode::Fault;
                   return !why.isEmpty() || needed ? why
                                                   : tr("Available only after a safety violation or fault.");
               }});
    table.add({"power.closePopups",
               commandText(RobotCommand::ClosePopups),
               tr("Closes the popups on the teach pendant."),
               {},
               hooks.closePopup,
               [obstacle = hooks.popupObstacle](const SessionState& s) {
                   const QString why = needsService(s, RobotCommand::ClosePopups);
                   return why.isEmpty() ? obstacle() : why;
               }});
}

void RobotActions::addControl(ActionTable& table, RobotSession& session, const RobotActionHooks& hooks) {
    const auto perform = [&session](RobotCommand command) {
        return [&session, command] { session.services().perform(command); };
    };
    table.add({"control.take",
               tr("Take control"),
               tr("Starts the control program on the robot. Asks for confirmation before stopping another "
                  "program."),
               {},
               [&session] { session.takeControl(); },
               [](const SessionState& s) {
                   const QString why = s.monitorOnly ? texts::monitorOnlyObstacle() : needsNormalSafety(s);
                   return !why.isEmpty()                         ? why
                          : s.robotMode != RobotMode::Running    ? robotModeWords(s.robotMode).advice
                          : s.control == ControlState::InControl ? tr("Already in control.")
                          : s.remoteNeeded                       ? texts::remoteObstacle()
                                                                 : QString();
               }});
    table.add({"control.release",
               tr("Give control back"),
               tr("Ends the control program on the robot."),
               {},
               [&session] { session.releaseControl(); },
               [](const SessionState& s) {
                   return s.control == ControlState::InControl ? QString() : tr("Not in control.");
               }});
    table.add({"control.stop",
               tr("Stop"),
               tr("Software stop of all motion. Not an emergency stop."),
               {},
               hooks.stop});
    table.add({"control.load",
               tr("Load program…"),
               tr("Loads a program on the robot by name."),
               {},
               hooks.askForProgram,
               [](const SessionState& s) { return needsForeignProgram(s, RobotCommand::Play, false); }});
    table.add({"control.play",
               commandText(RobotCommand::Play),
               tr("Starts the loaded program or resumes the paused program. The arm may move immediately."),
               {},
               perform(RobotCommand::Play),
               [](const SessionState& s) {
                   const QString why = needsForeignProgram(s, RobotCommand::Play, false);
                   return why.isEmpty() ? needsNormalSafety(s) : why;
               }});
    table.add({"control.pause",
               commandText(RobotCommand::Pause),
               tr("Pauses the running program."),
               {},
               perform(RobotCommand::Pause),
               [](const SessionState& s) { return needsForeignProgram(s, RobotCommand::Pause, true); }});
    table.add({"control.stopProgram",
               commandText(RobotCommand::StopProgram),
               tr("Stops the program on the robot."),
               {},
               perform(RobotCommand::StopProgram),
               [](const SessionState& s) {
                   const QString why = needsService(s, RobotCommand::StopProgram);
                   return !why.isEmpty()                         ? why
                          : s.control == ControlState::InControl ? tr("Give control back first.")
                          : s.runtimeState == RuntimeState::Stopped
                              ? tr("No program is running on the robot.")
                              : QString();
               }});
}

}  // namespace tiller::app
