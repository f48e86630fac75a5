// SPDX-License-Identifier: MIT
#pragma once

// "Go through": the waypoints of a route one after the other while a key is held, each by its own kind of move, at its
// own speed under the chosen one, and with its own blend. Let go is pause: the next press goes on to the coming
// waypoint, and two more keys go one waypoint on or back. Waypoints with a blend are joined into one path that the
// controller follows; where the arm stops anyway, or something is to be done, each way is a move of its own.
//
// What is to be done at a waypoint is done when the arm has come there, going on; going back does nothing. Let go
// in the middle of it, the next press brings the arm back there, if it has been moved away, and begins the action
// that was not ended anew.

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

    /// All must outlive it.
    /// state      where the arm is now
    /// heldSpeed  the speed that every move keeps below, asked at each
    RouteRunner(const MotionPort& port, const ActionPort& actions, const ProjectDocument& document,
                const SessionState& state, const std::function<HeldSpeed()>& heldSpeed,
                QObject* parent = nullptr);
    ~RouteRunner() override;

    /// The way goes through these rows of the document, and begins anew.
    void setRows(const QVector<int>& rows);
    /// After an edit of the document: the way goes through these rows now, and the coming one stays the coming one.
    void followRows(const QVector<int>& rows);
    void setLoop(bool loop);
    const WaypointRoute& route() const { return route_; }
    /// True from the first step on, until it begins anew.
    bool isUnderWay() const { return route_.isUnderWay(); }
    /// Row of the coming one; -1 behind the last.
    int comingRow() const;
    /// What is being done at it now; null for none.
    const project::WaypointAction* acting() const;

    /// For the key of that way.
    HoldMotion motion(Way way);
    /// Why it cannot go that way now, as a sentence; empty when it can. Of the route, not of the robot.
    QString obstacle(Way way) const;
    /// The same for what was said when it could not begin or go on.
    static QString whyNot(const Error& error);
    /// What a press would begin with, or goes on with now.
    Result<MoveRequest> firstMove(Way way) const;

Q_SIGNALS:
    /// Another waypoint is the coming one.
    void routeChanged();
    /// It ended before its end: a sentence that says why.
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
    /// -1 when it has gone.
    int rowOf(int place) const;
    QVector<QUuid> idsOf(const QVector<int>& rows) const;

    const MotionPort& port_;
    const ActionPort& actions_;
    const ProjectDocument& document_;
    const SessionState& state_;
    const std::function<HeldSpeed()>& heldSpeed_;
    WaypointRoute route_;
    QVector<int> rows_;              ///< of the route's places
    QVector<int> leg_;               ///< the places of the way under way
    int legs_ = 0;                   ///< begun since the press
    QUuid actingAt_;                 ///< the coming one, once the arm has come there and not all is done
    project::WaypointActions done_;  ///< there
    std::optional<project::WaypointAction> acting_;
    HoldToRunSequence through_;
    HoldToRunSequence stepOn_;
    HoldToRunSequence stepBack_;
};

}  // namespace tiller
