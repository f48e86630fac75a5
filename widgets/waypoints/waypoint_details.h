// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The lower end of the tab: the selected waypoint in figures, which can be typed, how far it is from where the
// arm stands, and the frame it is given in, which can be chosen. Typing moves nothing but the waypoint.

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
    /// What stands in the way from here to the waypoint; empty when nothing does.
    void setWayLimit(const QString& text);
    /// How many program steps use the waypoint; nothing is said before this has been told.
    void setUsedIn(std::optional<int> steps);
    /// A key that lets other keys of the tab take the place of the figures, where there is no room for both.
    void offerPlace(bool offered);
    /// The operator wants that place for those keys.
    bool isPlaceWanted() const;
    void setFiguresShown(bool shown);
    bool areFiguresShown() const { return figuresShown_; }
    int figuresHeight() const;  ///< With what is between them and the headline [px].

    QString headline() const;
    /// Its pose in words, for screen readers.
    QString poseLine() const { return poseLine_; }

Q_SIGNALS:
    void placeWanted();

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void showFrame();

    ProjectDocument& document_;
    WaypointModel& model_;
    int row_ = -1;
    std::optional<int> usedIn_;
    SessionState live_;
    QString wayLimit_;
    QStackedWidget* headlines_;  ///< name and facts, or what stands in the way
    QLabel* name_;
    ElidedLabel* facts_;
    QLabel* advice_;
    ChoiceBox* frame_;
    PoseEditor* pose_;
    QPushButton* place_;
    bool figuresShown_ = true;
    QString poseLine_;
};

}  // namespace tiller
