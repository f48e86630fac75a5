// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Asks how the selected waypoints are moved together: offset, turn or mirror image, in the axes of which frame.

#include <QDialog>
#include <array>

#include "robot/project/relative_move.h"

class QLabel;

namespace tiller {

class ChoiceBox;
class FigureBox;
class ProjectDocument;

class WaypointShift : public QDialog {
    Q_OBJECT

public:
    /// waypoints  at least one
    WaypointShift(const ProjectDocument& document, std::vector<project::Waypoint> waypoints,
                  QWidget* parent = nullptr);

    project::RelativeMove move() const;
    /// As they are after the move; the error says why there is none.
    Result<std::vector<project::Waypoint>> moved() const;

    void accept() override;

private:
    void refresh();

    const ProjectDocument& document_;
    std::vector<project::Waypoint> waypoints_;
    ChoiceBox* kind_;
    ChoiceBox* axes_;
    ChoiceBox* axis_;
    std::array<FigureBox*, 3> offset_{};
    FigureBox* angle_;
    QLabel* feedback_;
};

}  // namespace tiller
