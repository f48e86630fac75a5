// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tab "Waypoints": teach, touch up, order and edit the places of a cell, and go to one while a key is
// held. What it shows of a waypoint before the arm moves (ghost, marks) others draw.

#include <QTimer>
#include <QUuid>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "robot/project/waypoint_list.h"
#include "widgets/common/hold_rules.h"
#include "widgets/common/physical_keys.h"
#include "widgets/session/robot_session.h"

class QAction;
class QKeyEvent;
class QLabel;
class QPushButton;
class QStackedWidget;
class QToolButton;

namespace tiller {

class HoldButton;
class NoticeBar;
class ProjectDocument;
class WaypointDetails;
class WaypointModel;
class WaypointTable;

/// The few doors through which the tab moves the arm, so that it can be tried without a robot.
struct WaypointPort {
    std::function<Result<RobotSession::MotionId>(const MoveRequest&)> beginMove;
    std::function<bool(RobotSession::MotionId)> hold;
    std::function<void(RobotSession::MotionId, control::StopCause)> endMotion;
    std::function<control::MotionLimits()> limits;
};
/// The doors of a session, which must outlive the port.
WaypointPort waypointPort(RobotSession& session);

/// The selected waypoint as a target to be shown before the arm goes there.
struct WaypointGhost {
    QString name;
    JointPositions q;
    bool linear = false;  ///< MoveL
    bool reachable = true;
    double speed = 0;         ///< [rad/s], or [m/s] when linear
    double acceleration = 0;  ///< [rad/s2], or [m/s2]
};

/// A waypoint's place, for the 3D view.
struct WaypointMark {
    QString name;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of the TCP, in the base frame [m]
    bool selected = false;
};

class WaypointsTab : public QWidget {
    Q_OBJECT

public:
    /// document  must outlive the tab
    WaypointsTab(RobotSession& session, ProjectDocument& document, QWidget* parent = nullptr);
    /// For tests: moves go through `port`, states still come from the session.
    WaypointsTab(RobotSession& session, ProjectDocument& document, WaypointPort port,
                 QWidget* parent = nullptr);
    ~WaypointsTab() override;

    WaypointModel& model() { return *model_; }

    /// Every action with its shortcut, for menus, the command palette and the help.
    QList<QAction*> commandActions() const { return actions_; }

    /// Adds what concerns the whole project to the end of the tab's own menu.
    void addToMenu(const QList<QAction*>& actions);

    std::optional<WaypointGhost> ghost() const;
    std::vector<WaypointMark> marks() const;

    /// Row of the selected waypoint; -1 for none.
    int currentRow() const;

public Q_SLOTS:
    /// Adds the live place after the selection.
    void teach();
    /// Shows how far the live place is from the selected waypoint and asks before it replaces it.
    void touchUp();
    void selectWaypoint(const QUuid& id);
    void selectRow(int row);
    /// accept  label of the key that runs `accepted`; empty for a warning that only needs to be put away
    void showNotice(const QString& title, const QString& text, const QString& accept = {},
                    const std::function<void()>& accepted = {});

Q_SIGNALS:
    /// Another waypoint, or none (null), is selected.
    void selectionChanged(const QUuid& waypoint);
    /// ghost() is another one.
    void ghostChanged();
    /// marks() are others.
    void marksChanged();
    /// Something the operator should be able to read again later.
    void message(tiller::Severity severity, const QString& text);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void buildActions();
    void buildLayout();
    void setUpGoTo();
    void onState(const SessionState& state);
    void onSelection();
    void refreshDetails();
    void updateAvailability();
    QString goToObstacle() const;
    Result<RobotSession::MotionId> beginGoTo();
    void replaceByTouchUp(const QUuid& id, const project::Waypoint& taught);
    QString teachObstacle() const;
    void duplicateSelected();
    void deleteSelected();
    void moveSelected(int by);
    void copySelected();
    void paste();
    void showProblem(const QString& text);
    QAction* addCommand(const QString& name, const QString& text, const QKeySequence& shortcut,
                        std::function<void()> run);
    bool typingSomewhere() const;
    bool goToKey(const QKeyEvent& key);

    RobotSession& session_;
    WaypointPort port_;
    SessionState state_;
    ProjectDocument& document_;
    std::unique_ptr<WaypointModel> model_;
    QList<QAction*> actions_;
    QTimer detailsTimer_;
    QUuid lastSelected_;
    HoldBounds goToBounds_;
    PhysicalKeys goToKey_;  ///< the key that holds "Go to", while it is down

    QPushButton* teach_ = nullptr;
    QPushButton* touchUp_ = nullptr;
    HoldButton* goTo_ = nullptr;
    QToolButton* more_ = nullptr;
    NoticeBar* notice_ = nullptr;
    QStackedWidget* pages_ = nullptr;
    WaypointTable* table_ = nullptr;
    WaypointDetails* details_ = nullptr;
};

}  // namespace tiller
