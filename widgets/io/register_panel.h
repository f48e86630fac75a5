// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// General purpose registers. Shows the output registers reported by the robot. One line writes an input
// register, which a program on the robot can read.

#include <QMap>
#include <QWidget>

#include "robot/receive/robot_state.h"
#include "robot/station/link/io_commands.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace tiller {

class DecimalSpinBox;

class RegisterPanel : public QWidget {
    Q_OBJECT

public:
    explicit RegisterPanel(QWidget* parent = nullptr);

    /// Shows the values of this sample. A missing field is shown as a dash.
    void show(const receive::RobotState& robot, bool stale);
    void showNothing();
    /// reason  why registers cannot be written, as a sentence; empty if they can be written
    void setLock(const QString& reason);
    /// Hides rows that do not match.
    /// Returns  true if any row matches
    bool filter(const QString& text);
    QString valueText(const QString& registerName) const;

Q_SIGNALS:
    void writeRequested(const tiller::RegisterValue& value);

private:
    struct Row {
        QLabel* name;
        QLabel* value;
        std::string field;
        bool whole;
    };
    void fitKind();

    QMap<QString, Row> rows_;
    QComboBox* kind_;
    DecimalSpinBox* number_;
    DecimalSpinBox* value_;
    QPushButton* write_;
};

}  // namespace tiller
