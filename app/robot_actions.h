// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The commands for the robot: connection, power, recovery, control, and programs on the robot. Each disabled
// command shows a reason.

#include <QCoreApplication>
#include <functional>

#include "robot/station/link/robot_session.h"

namespace tiller::app {

class ActionTable;

/// Functions of the main window.
struct RobotActionHooks {
    std::function<void()> askForRobot;
    std::function<void()> connectSimulator;
    std::function<void()> disconnect;
    std::function<void(const RobotAddress&)> check;
    std::function<void()> showRecovery;
    std::function<void()> askForProgram;
    /// Closes the newest popup, like the button on its card. popupObstacle() returns the reason why it cannot
    /// be closed now.
    std::function<void()> closePopup;
    std::function<QString()> popupObstacle;
    /// Stops all motion by software.
    std::function<void()> stop;
};

class RobotActions {
    Q_DECLARE_TR_FUNCTIONS(RobotActions)

public:
    /// session  must outlive the table
    static void addTo(ActionTable& table, RobotSession& session, const RobotActionHooks& hooks);

private:
    static void addConnection(ActionTable& table, RobotSession& session, const RobotActionHooks& hooks);
    static void addPower(ActionTable& table, RobotSession& session, const RobotActionHooks& hooks);
    static void addControl(ActionTable& table, RobotSession& session, const RobotActionHooks& hooks);
};

}  // namespace tiller::app
