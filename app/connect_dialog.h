// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which robot: the simulated one, or one at an address. The first thing a newcomer sees, and what the robot
// selector of the header opens.

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
    explicit ConnectDialog(const QStringList& rememberedHosts, QWidget* parent = nullptr);

    bool wantsSimulator() const { return simulator_; }
    /// Name and host as entered; the port offset of "host:+100" understood.
    RobotAddress address() const;

private:
    void updateButtons();

    QLineEdit* host_;
    QLineEdit* name_;
    QPushButton* connect_;
    QLabel* hint_;
    bool simulator_ = false;
};

/// Whether this could be a host name or an address; the reason why not otherwise, empty when it could.
QString hostProblem(const QString& host);

}  // namespace tiller::app
