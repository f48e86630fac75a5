// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Details of the selected waypoint below the list: editable values, distance from the current position, and
// the frame of the waypoint. Editing a value changes the waypoint and does not move the arm.

#include <QWidget>
#include <optional>

#include "robot/project/waypoint_list.h"
#include "robot/station/link/session_state.h"

class QLabel;
class QPushButton;
class QStackedWidget;

namespace tiller {

class ChoiceBox;
class ElidedLabel;
class PoseEditor;
class ProjectDocument;
class WaypointModel;

class WaypointDetails : public QWidget {
    Q_OBJECT

public:
    WaypointDetails(ProjectDocument& document, WaypointModel& model, QWidget* parent = nullptr);

    /// row  -1 for none
    void setWaypoint(int row);
    void setLive(const SessionState& state);
    /// Shows the limit on the path to the waypoint; empty if there is none.
    void setPathLimitText(const QString& text);
    /// Sets the number of program steps that use the waypoint. An empty value hides the number, as initially.
    void setUsedIn(std::optional<int> steps);
    /// Shows or hides the button that switches between the values and the route controls. It is needed if
    /// there is not enough space for both.
    void offerPlace(bool offered);
    /// True if the user switched to the route controls.
    bool isPlaceWanted() const;
    void setValuesVisible(bool shown);
    bool areValuesVisible() const { return valuesVisible_; }
    int valuesHeight() const;  ///< height of the values, including the spacing to the headline [px]
    /// Reserves this height for the values, including their spacing [px]; 0 restores the natural height.
    void setValuesSlot(int height);

    QString headline() const;
    /// The pose as text, for screen readers.
    QString poseLine() const { return poseLine_; }

Q_SIGNALS:
    void placeWanted();

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    QString tcpText(const Pose& offset) const;
    void showFrame();

    ProjectDocument& document_;
    WaypointModel& model_;
    int row_ = -1;
    std::optional<int> usedIn_;
    SessionState live_;
    QString pathLimitText_;
    QStackedWidget* headlines_;  ///< name and properties, or the limit on the path
    QLabel* name_;
    ElidedLabel* facts_;
    QLabel* advice_;
    ChoiceBox* frame_;
    PoseEditor* pose_;
    QPushButton* place_;
    bool valuesVisible_ = true;
    QString poseLine_;
};

}  // namespace tiller
