// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// General purpose registers: the output registers the robot reports, and one line to write an input register
// that a program on the robot reads.

#include <QMap>
#include <QWidget>

#include "robot/receive/robot_state.h"
#include "robot/station/link/io_commands.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace tiller {

class FigureBox;

class RegisterPanel : public QWidget {
    Q_OBJECT

public:
    explicit RegisterPanel(QWidget* parent = nullptr);

    /// Shows what is in this sample; fields it does not have show a dash.
    void show(const receive::RobotState& robot, bool stale);
    void showNothing();
    /// reason  why nothing can be written, as a sentence; empty: it can
    void setLock(const QString& reason);
    /// Hides the rows that do not match.
    /// Returns  whether any does
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
    FigureBox* number_;
    FigureBox* value_;
    QPushButton* write_;
};

}  // namespace tiller
