// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The lower end of the tab: the selected waypoint in figures, how far it is from where the arm stands, and
// the frame it is given in, which can be chosen here.

#include <QWidget>
#include <optional>

#include "robot/project/waypoint_list.h"
#include "widgets/session/session_state.h"

class QLabel;

namespace tiller {

class ChoiceBox;
class ElidedLabel;
class ProjectDocument;
class WaypointModel;

class WaypointDetails : public QWidget {
    Q_OBJECT

public:
    WaypointDetails(ProjectDocument& document, WaypointModel& model, QWidget* parent = nullptr);

    /// row  -1 for none
    void setWaypoint(int row);
    void setLive(const SessionState& state);
    /// How many program steps use the waypoint; nothing is said before this has been told.
    void setUsedIn(std::optional<int> steps);

    QString headline() const;
    QString poseLine() const;

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void refresh();
    void fitPose();
    void showFrame();

    ProjectDocument& document_;
    WaypointModel& model_;
    int row_ = -1;
    std::optional<int> usedIn_;
    SessionState live_;
    QLabel* name_;
    ElidedLabel* facts_;
    ChoiceBox* frame_;
    ElidedLabel* pose_;
    ElidedLabel* advice_;
};

}  // namespace tiller
