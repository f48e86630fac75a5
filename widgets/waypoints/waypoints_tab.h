// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tab "Waypoints": teaches, touches up, reorders and edits waypoints, and moves the arm to a waypoint
// while a button is held. The 3D view draws the preview of a waypoint (ghost, marks).

#include <QTimer>
#include <QUuid>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "robot/project/waypoint_list.h"
#include "robot/station/link/gripper_port.h"
#include "robot/station/link/motion_port.h"
#include "robot/station/link/move_time.h"
#include "widgets/common/notice_bar.h"
#include "widgets/common/scene_marks.h"

class QAction;
class QPushButton;
class QStackedWidget;

namespace tiller {

class FoldingRow;
class GoThroughBar;
class GoToButton;
class NoticeBar;
class PathControls;
class PathWatch;
class UndoableDocument;
class WaypointDetails;
class WaypointDialogs;
class WaypointEditing;
class WaypointModel;
class WaypointSearch;
class WaypointTable;
struct HoldPolicy;

class WaypointsTab : public QWidget {
    Q_OBJECT

public:
    /// session, document, policy  must outlive the tab
    WaypointsTab(RobotSession& session, UndoableDocument& document, HoldPolicy& policy,
                 QWidget* parent = nullptr);
    /// For tests: `port` executes the moves. The states are still those of the session.
    WaypointsTab(RobotSession& session, UndoableDocument& document, MotionPort port, HoldPolicy& policy,
                 QWidget* parent = nullptr);
    ~WaypointsTab() override;

    WaypointModel& model() { return *model_; }
    WaypointDialogs& dialogs() { return *dialogs_; }

    /// All actions with their shortcuts, for the menus, the command list and the help page.
    QList<QAction*> commandActions() const { return actions_; }

    /// Adds actions for the whole project to the submenu "Project" at the end of the tab's menu.
    void addToMenu(const QList<QAction*>& actions);

    /// Shows the limit on the path to the selected waypoint next to "Go to (hold)"; empty if there is none.
    void setPathLimitText(const QString& text);
    /// Sets the function that returns the speed limit for "Go to". Each press calls it. Without a function,
    /// the default HeldSpeed applies.
    void setHeldSpeed(std::function<HeldSpeed()> speed);
    /// Sets the gripper used by "Run route". Initially, no gripper is set.
    void setGripper(GripperPort gripper);

    std::optional<Ghost> ghost() const;
    /// The new position of the waypoint while a touch-up is being confirmed. ghost() is then the current
    /// position.
    const std::optional<Ghost>& touchUpGhost() const { return touchUpGhost_; }
    std::vector<WaypointMark> marks() const;

    /// Row of the selected waypoint; -1 for none.
    int currentRow() const;

    /// Minimum time for which a notice that closes automatically is shown [ms].
    static constexpr int kPassingMs = 5000;

    /// Includes the details, even if they are hidden.
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

public Q_SLOTS:
    /// Adds a waypoint at the current position after the selected row.
    void teach();
    /// Shows the distance between the current position and the selected waypoint, and asks for confirmation
    /// before replacing the waypoint. The question follows the arm. The position at the confirmation is
    /// stored.
    void touchUp();
    void selectWaypoint(const QUuid& id);
    void selectRow(int row);
    /// Ends a motion of "Run route" and updates the displayed speeds. Call this after a change of the speed
    /// limit.
    void followSpeed();
    /// True while a path is being recorded or simplified to waypoints.
    bool isStoringPath() const;
    /// Stops recording a path. Returns true if the path has not been stored yet. In that case, pathStored()
    /// is emitted later.
    bool storePath();
    void showNotice(const Notice& notice);
    void resolveNotice(const QString& cause);

Q_SIGNALS:
    /// The selection has changed. Null if no waypoint is selected.
    void selectionChanged(const QUuid& waypoint);
    void ghostChanged();
    void marksChanged();
    /// A recorded path was converted to waypoints, or it contained no motion.
    void pathStored();

private:
    void buildActions();
    void buildLayout(MotionPort port, HoldPolicy& policy);
    /// Like teach(). If the focus is outside the tab, also moves it to the table and shows a notice with
    /// "Undo".
    void teachByKey();
    void fitRoutes();
    void showPathRecording();
    void onState(const SessionState& state);
    void onSelection();
    void refreshDetails();
    void updateAvailability();
    QString goToObstacle() const;
    Result<MoveRequest> goToRequest();
    Result<MoveRequest> moveTo(int row) const;
    void onComing();
    /// The waypoint of this row at the current position; nullopt if its frame is missing.
    std::optional<project::Waypoint> taughtNow(int row) const;
    QString touchUpText(const QUuid& id) const;
    void replaceByTouchUp(const QUuid& id);
    QString teachObstacle() const;
    QString positionObstacle() const;
    void showSpeed();
    void setTouchUpGhost(const std::optional<Ghost>& ghost);
    void showProblem(const QString& text, const QString& details = {});
    QAction* addCommand(const QString& name, const QString& text, const QKeySequence& shortcut,
                        std::function<void()> run);

    RobotSession& session_;
    const HoldPolicy& holdPolicy_;
    std::function<control::MotionLimits()> limits_;
    std::function<HeldSpeed()> heldSpeed_ = [] { return HeldSpeed(); };
    SessionState state_;
    UndoableDocument& document_;
    std::unique_ptr<WaypointModel> model_;
    QList<QAction*> actions_;
    QTimer detailsTimer_;
    QTimer passing_;
    QUuid lastSelected_;
    std::optional<Ghost> touchUpGhost_;

    QPushButton* teach_ = nullptr;
    QPushButton* touchUp_ = nullptr;
    GoToButton* goTo_ = nullptr;
    GoThroughBar* goThrough_ = nullptr;
    PathControls* paths_ = nullptr;
    FoldingRow* routes_ = nullptr;  ///< contains goThrough_ and paths_
    QPushButton* more_ = nullptr;
    NoticeBar* notice_ = nullptr;
    QStackedWidget* pages_ = nullptr;
    WaypointTable* table_ = nullptr;
    WaypointDetails* details_ = nullptr;
    WaypointEditing* editing_ = nullptr;
    WaypointDialogs* dialogs_ = nullptr;
    WaypointSearch* search_ = nullptr;
    PathWatch* watch_ = nullptr;
};

}  // namespace tiller
