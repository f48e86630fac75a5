// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Edits properties of one or several waypoints: group, colour, note, move type, speeds and blend radius. Only
// checked properties are changed, so that many waypoints can be edited together.

#include <QDialog>
#include <vector>

#include "robot/project/waypoint_list.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QPlainTextEdit;

namespace tiller {

class ChoiceBox;
class DecimalSpinBox;

class WaypointProperties : public QDialog {
    Q_OBJECT

public:
    /// groups     existing groups to select from
    /// waypoints  at least one
    WaypointProperties(const std::vector<project::Waypoint>& waypoints, const QStringList& groups,
                       double mostJointSpeed, QWidget* parent = nullptr);

    std::vector<project::Waypoint> changed() const;

    /// One translated name per colour, e.g. "None", "Blue".
    static QStringList colourNames();

    void accept() override;

private:
    QCheckBox* addRow(QGridLayout& grid, const QString& name, const QString& text, QWidget* editor);
    DecimalSpinBox* addValue(QGridLayout& grid, const QString& name, const QString& text, const QString& unit,
                             double least, double most, QCheckBox*& tick);

    std::vector<project::Waypoint> waypoints_;
    QComboBox* group_;
    ChoiceBox* colour_;
    QPlainTextEdit* note_;
    ChoiceBox* move_;
    DecimalSpinBox* jointSpeed_;
    DecimalSpinBox* toolSpeed_;
    DecimalSpinBox* blend_;
    QCheckBox* groupTick_;
    QCheckBox* colourTick_;
    QCheckBox* noteTick_;
    QCheckBox* moveTick_;
    QCheckBox* jointSpeedTick_;
    QCheckBox* toolSpeedTick_;
    QCheckBox* blendTick_;
};

}  // namespace tiller
