// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The first thing a newcomer sees: try the simulator, connect a robot, or open a session.

#include <QDialog>

#include "widgets/session/robot_session.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace tiller::app {

class ConnectDialog : public QDialog {
    Q_OBJECT

public:
    enum class Choice { Simulator, Robot, Project };

    explicit ConnectDialog(const QVector<RobotAddress>& remembered, QWidget* parent = nullptr);

    /// What was chosen, once accepted.
    Choice choice() const { return choice_; }
    /// Name and host as entered; the port offset of "host:+100" understood.
    RobotAddress address() const;

protected:
    void showEvent(QShowEvent* event) override;

private:
    void updateButtons();
    void choose(Choice choice);

    QLineEdit* host_;
    QLineEdit* name_;
    QPushButton* connect_;
    QLabel* hint_;
    int portOffset_ = 0;  ///< of the remembered robot, if its address was not changed
    Choice choice_ = Choice::Robot;
};

/// Whether this could be a host name or an address; the reason why not otherwise, empty when it could.
QString hostProblem(const QString& host);

}  // namespace tiller::app
