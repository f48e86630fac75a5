// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The start dialog: try the simulator, connect a robot, or open a project.

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

    /// remembered  newest first
    explicit ConnectDialog(const QVector<RobotAddress>& remembered, QWidget* parent = nullptr);

    /// The selection, once accepted.
    Choice choice() const { return choice_; }
    /// Name and host as entered, with the port offset of a remembered robot if its address was not changed.
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
    /// The default button depends on the input.
    void updateButtons();
    void showRobot(int row);
    void forgetRobot();
    /// Until it is edited, the name is the one remembered for the address.
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

/// The reason why the text cannot be a host name or an address; empty if it can.
QString hostProblem(const QString& host);

}  // namespace tiller::app
