// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The start dialog. The user can start the simulator, connect to a robot, or open a project.

#include <QDialog>

#include "robot/station/link/robot_session.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace tiller::app {

class ConnectDialog : public QDialog {
    Q_OBJECT

public:
    enum class Choice { Simulator, Sample, Robot, Project };

    /// remembered  remembered robots, newest first
    explicit ConnectDialog(const QVector<RobotAddress>& remembered, QWidget* parent = nullptr);

    /// The selection of the user. Valid after the dialog has been accepted.
    Choice choice() const { return choice_; }
    /// Name and host as entered. If the address of a remembered robot was not changed, includes the port
    /// offset of that robot.
    RobotAddress address() const;

Q_SIGNALS:
    /// The user removed this robot from the list.
    void forgetRequested(const tiller::RobotAddress& robot);

protected:
    void showEvent(QShowEvent* event) override;

private:
    QWidget* simulatorPart();
    QWidget* robotPart();
    void choose(Choice choice);
    /// Sets the default button according to the input.
    void updateButtons();
    void showRobot(int row);
    void forgetRobot();
    /// Fills in the remembered name of the entered address, unless the user has edited the name.
    void followAddress();

    QVector<RobotAddress> remembered_;
    QLineEdit* host_;
    QLineEdit* name_;
    QListWidget* list_;
    QPushButton* forget_;
    QPushButton* simulator_;
    QPushButton* sample_;
    QPushButton* connect_;
    QLabel* hint_;
    bool nameTyped_ = false;
    Choice choice_ = Choice::Robot;
};

/// Returns the reason why the text is not a valid host name or address; empty if it is valid.
QString hostProblem(const QString& host);

}  // namespace tiller::app
