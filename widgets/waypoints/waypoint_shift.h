// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Dialog for moving the selected waypoints together by an offset, a rotation or a mirror image in a
// selectable frame.

#include <QDialog>
#include <array>

#include "robot/project/relative_move.h"

class QLabel;

namespace tiller {

class ChoiceBox;
class DecimalSpinBox;
class ProjectDocument;

class WaypointShift : public QDialog {
    Q_OBJECT

public:
    /// waypoints  at least one
    WaypointShift(const ProjectDocument& document, std::vector<project::Waypoint> waypoints,
                  QWidget* parent = nullptr);

    project::RelativeMove move() const;
    /// The waypoints after the move, or the reason why the move is not possible.
    Result<std::vector<project::Waypoint>> moved() const;

    void accept() override;

private:
    void refresh();

    const ProjectDocument& document_;
    std::vector<project::Waypoint> waypoints_;
    ChoiceBox* kind_;
    ChoiceBox* axes_;
    ChoiceBox* axis_;
    std::array<DecimalSpinBox*, 3> offset_{};
    DecimalSpinBox* angle_;
    QLabel* feedback_;
};

}  // namespace tiller
