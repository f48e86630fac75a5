// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The first thing a newcomer sees: try the simulator, connect a robot, or open a project.

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

    /// What was chosen, once accepted.
    Choice choice() const { return choice_; }
    /// Name and host as entered; the port offset of a remembered robot if its address was not changed.
    RobotAddress address() const;

Q_SIGNALS:
    /// The operator does not want to be offered it any more.
    void forgetRequested(const tiller::RobotAddress& robot);

protected:
    void showEvent(QShowEvent* event) override;

private:
    QWidget* simulatorPart();
    QWidget* robotPart();
    void choose(Choice choice);
    /// What Return does follows from what is entered.
    void updateButtons();
    void showRobot(int row);
    void forgetRobot();
    /// A name belongs to the address it was remembered with, until it is typed.
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

/// Whether this could be a host name or an address; the reason why not otherwise, empty when it could.
QString hostProblem(const QString& host);

}  // namespace tiller::app
