// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The lower end of the tab: the selected waypoint in figures, and how far it is from where the arm stands.

#include <QWidget>
#include <optional>

#include "robot/program/waypoint_list.h"
#include "widgets/session/session_state.h"

class QLabel;

namespace tiller {

class ElidedLabel;
class WaypointModel;

class WaypointDetails : public QWidget {
    Q_OBJECT

public:
    explicit WaypointDetails(const WaypointModel& model, QWidget* parent = nullptr);

    /// row  -1 for none
    void setWaypoint(int row);
    void setLive(const SessionState& state);
    /// How many program steps use the waypoint; nothing is said before this has been told.
    void setUsedIn(std::optional<int> steps);

    QString headline() const;
    QString poseLine() const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void refresh();

    const WaypointModel& model_;
    int row_ = -1;
    std::optional<int> usedIn_;
    SessionState live_;
    QLabel* name_;
    ElidedLabel* facts_;
    ElidedLabel* pose_;
    ElidedLabel* advice_;
};

/// "X 120.00 Y 80.00 Z 150.00 mm  RX 180.00 RY 0.00 RZ 0.00°"
QString poseText(const Pose& pose);
/// "61.2 mm, 4.1°"
QString differenceText(const program::PoseDifference& difference);

}  // namespace tiller
