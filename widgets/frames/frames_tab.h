// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tab "Frames". Teaches frames from the TCP pose or from three points, and renames, edits and touches up
// the frames of the open project. The tab does not move the robot.

#include <QTimer>
#include <QUuid>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "robot/project/waypoint.h"
#include "robot/station/link/robot_session.h"
#include "widgets/common/scene_marks.h"

class QAction;
class QPushButton;
class QStackedWidget;

namespace tiller {

class FrameDetails;
class FrameEditing;
class FrameModel;
class FrameTable;
class FrameTeacher;
class NoticeBar;
class ProjectDocument;

class FramesTab : public QWidget {
    Q_OBJECT

public:
    /// document  must outlive the tab
    FramesTab(RobotSession& session, ProjectDocument& document, QWidget* parent = nullptr);
    ~FramesTab() override;

    FrameModel& model() { return *model_; }
    /// All actions with their shortcuts, for the menus, the command list and the help page.
    QList<QAction*> commandActions() const { return actions_; }
    std::vector<FrameMark> marks() const;
    /// Row of the selected frame; -1 if there is none.
    int currentRow() const;

public Q_SLOTS:
    /// Creates a frame at the TCP pose.
    void teachFromTcp();
    void teachThreePoints();
    /// Asks for confirmation before moving the selected frame to the TCP. The question shows how the frame
    /// and its waypoints would move, and follows the TCP. The pose at the confirmation is stored.
    void touchUp();
    void touchUpThreePoints();
    void selectRow(int row);

Q_SIGNALS:
    void marksChanged();
    void jogRequested(const QUuid& frame);
    /// A command needs this tab to be visible.
    void frontWanted();

private:
    void buildLayout();
    void buildActions();
    QAction* addCommand(const QString& name, const QString& text, const QKeySequence& shortcut,
                        std::function<void()> run);
    void onState(const SessionState& state);
    void showLive();
    void onSelection();
    void onFrames();
    void showPage();
    void updateAvailability();
    std::optional<project::Frame> current() const;

    void insert(const Pose& T_base_frame);
    void withCurrent(void (FrameEditing::*edit)(const project::Frame&));
    void beginTeaching(const QUuid& into);
    void endTeaching();
    void onMade(const Pose& T_base_frame);
    void showProblem(const QString& text);

    SessionState state_;
    ProjectDocument& document_;
    FrameModel* model_;
    QList<QAction*> actions_;
    QTimer liveTimer_;
    QUuid selected_;
    QVector<QUuid> known_;  ///< IDs of the frames before the last change, for finding an added frame
    bool teaching_ = false;
    QUuid teachingInto_;  ///< frame to touch up; null to create a new frame

    QPushButton* fromTcp_ = nullptr;
    QPushButton* threePoints_ = nullptr;
    QPushButton* touchUp_ = nullptr;
    QPushButton* more_ = nullptr;
    QWidget* keys_ = nullptr;
    NoticeBar* notice_ = nullptr;
    QStackedWidget* pages_ = nullptr;
    FrameTable* table_ = nullptr;
    FrameTeacher* teacher_ = nullptr;
    FrameDetails* details_ = nullptr;
    FrameEditing* editing_ = nullptr;
};

}  // namespace tiller
