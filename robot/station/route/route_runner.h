// SPDX-License-Identifier: MIT
#pragma once

// Implements "Run route": moves through the waypoints of a route while a button is held. Each move has the
// move type, the speed (limited by the selected speed), and the blend of its waypoint. Releasing the button
// pauses the route, and the next press continues to the next waypoint. Two more buttons move one waypoint
// forward or back. Waypoints with a blend are combined into one path of the controller. At waypoints where
// the arm stops or an action is executed, a separate move begins.
//
// Actions of a waypoint are executed on arrival in forward direction only. If the button is released during
// an action, the next press moves the arm back to the waypoint if necessary, and restarts the incomplete
// action.

#include <QObject>
#include <QVector>
#include <functional>
#include <memory>
#include <optional>

#include "robot/station/link/move_time.h"
#include "robot/station/route/action_step.h"
#include "robot/station/route/hold_to_run_sequence.h"
#include "robot/station/route/waypoint_route.h"

namespace tiller {

class ProjectDocument;

class RouteRunner : public QObject {
    Q_OBJECT

public:
    enum class Way { Through, StepOn, StepBack };

    /// All references must outlive the object.
    /// state      must always contain the current state of the arm
    /// heldSpeed  returns the maximum speed; called for every move
    RouteRunner(const MotionPort& port, const ActionPort& actions, const ProjectDocument& document,
                const SessionState& state, const std::function<HeldSpeed()>& heldSpeed,
                QObject* parent = nullptr);
    ~RouteRunner() override;

    /// Sets the waypoint rows to run and restarts the route.
    void setRows(const QVector<int>& rows);
    /// Call after an edit of the document. Sets the rows and keeps the next waypoint.
    void followRows(const QVector<int>& rows);
    void setLoop(bool loop);
    const WaypointRoute& route() const { return route_; }
    /// True from the first step until a restart.
    bool isUnderWay() const { return route_.isUnderWay(); }
    /// Row of the next waypoint; -1 after the last waypoint.
    int comingRow() const;
    /// The action being executed, or null.
    const project::WaypointAction* acting() const;

    /// The hold-to-run motion for the button of this direction.
    HoldMotion motion(Way way);
    /// Why the route does not permit this direction, as a sentence; empty if it does. Independent of the
    /// robot.
    QString obstacle(Way way) const;
    /// Text for an error at the start or during the motion.
    static QString whyNot(const Error& error);
    /// The current move, or the move that a button press would start.
    Result<MoveRequest> firstMove(Way way) const;

Q_SIGNALS:
    void routeChanged();
    /// The run has been aborted. `reason` is a translated sentence.
    void failed(const QString& reason);

private:
    Result<std::unique_ptr<SequenceStep>> nextStep(Way way);
    Result<std::unique_ptr<SequenceStep>> nextLeg(Way way);
    void finishStep(Way way);
    bool isThere(int place) const;
    bool isActingAt(int place) const;
    void endActing();
    void showNoAction();
    void fail(const Error& error);
    const project::WaypointAction* nextAction();
    QString actionObstacle(Way way) const;
    Result<void> permits(Way way) const;
    int lastPlace(Way way) const;
    std::optional<int> firstPlace(Way way) const;
    QVector<int> legFrom(int place, Way way) const;
    Result<MoveRequest> moveTo(int place, const SessionState& from) const;
    Result<std::vector<MoveRequest>> movesOf(const QVector<int>& leg) const;
    control::MotionPath pathOf(const QVector<int>& leg, const std::vector<MoveRequest>& moves) const;
    HoldBounds bounds(Way way) const;
    void headFor(int place, Way way);
    /// Returns -1 if the waypoint was removed.
    int rowOf(int place) const;
    QVector<QUuid> idsOf(const QVector<int>& rows) const;

    const MotionPort& port_;
    const ActionPort& actions_;
    const ProjectDocument& document_;
    const SessionState& state_;
    const std::function<HeldSpeed()>& heldSpeed_;
    WaypointRoute route_;
    QVector<int> rows_;              ///< waypoint rows of the route
    QVector<int> leg_;               ///< the waypoints of the current segment
    int legs_ = 0;                   ///< segments started since the button was pressed
    QUuid actingAt_;                 ///< last reached waypoint, while its actions are incomplete
    project::WaypointActions done_;  ///< completed actions
    std::optional<project::WaypointAction> acting_;
    HoldToRunSequence through_;
    HoldToRunSequence stepOn_;
    HoldToRunSequence stepBack_;
};

}  // namespace tiller
