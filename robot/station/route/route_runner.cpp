// SPDX-License-Identifier: MIT
#include "robot/station/route/route_runner.h"

#include <algorithm>
#include <utility>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/station/document/project_document.h"
#include "robot/station/route/waypoint_motion.h"
#include "robot/station/text/reach_words.h"
#include "robot/station/text/texts.h"

namespace tiller {
namespace {

/// Two blends must not overlap, so each blend ends before the middle of the segment [fraction].
constexpr double kBlendShare = 0.49;
/// Smaller blends are ignored [m].
constexpr double kMinBlend = 1e-4;
/// Number of segments examined in detail to estimate the total duration.
constexpr int kLookedAt = 32;

/// State of the arm after the move.
SessionState after(const MoveRequest& move, SessionState state) {
    state.q = move.q;
    state.tcpPose = kinematics::forwardTcp(state.dh, move.q, state.tcpOffset);
    return state;
}

}  // namespace

RouteRunner::RouteRunner(const MotionPort& port, const ActionPort& actions, const ProjectDocument& document,
                         const SessionState& state, const std::function<HeldSpeed()>& heldSpeed,
                         QObject* parent)
    : QObject(parent)
    , port_(port)
    , actions_(actions)
    , document_(document)
    , state_(state)
    , heldSpeed_(heldSpeed)
    , through_(
          port.stops, [this] { return nextStep(Way::Through); }, [this](const Error& error) { fail(error); })
    , stepOn_(
          port.stops, [this] { return nextStep(Way::StepOn); }, [this](const Error& error) { fail(error); })
    , stepBack_(
          port.stops, [this] { return nextStep(Way::StepBack); },
          [this](const Error& error) { fail(error); }) {}

QString RouteRunner::whyNot(const Error& error) {
    // These errors are complete sentences.
    const bool said = error.code == ErrorCode::NoSolution || error.code == ErrorCode::Cancelled;
    return said && error.controllerMessage.isEmpty() ? error.context : texts::errorText(error);
}

RouteRunner::~RouteRunner() = default;

HoldMotion RouteRunner::motion(Way way) {
    HoldToRunSequence& sequence = way == Way::Through ? through_ : way == Way::StepOn ? stepOn_ : stepBack_;
    HoldMotion motion = sequence.motion([this, way] { return bounds(way); });
    motion.begin = [this, way, begin = std::move(motion.begin)]() -> Result<HoldMotion::Id> {
        if (way != Way::StepBack && route_.isDone()) {
            route_.restartRoute();
        }
        const QString why = obstacle(way);
        if (const QString all = why.isEmpty() ? actionObstacle(way) : why; !all.isEmpty()) {
            return Error{ErrorCode::NoSolution, all, {}};
        }
        if (const Result<void> permitted = permits(way); !permitted) {
            return permitted.error();
        }
        leg_.clear();
        legs_ = 0;
        acting_.reset();
        if (way == Way::StepBack) {
            endActing();
        }
        return begin();
    };
    // When the motion has ended for any reason, no action is active.
    motion.hold = [this, hold = std::move(motion.hold)](HoldMotion::Id id) {
        const bool alive = hold(id);
        if (!alive) {
            showNoAction();
        }
        return alive;
    };
    motion.end = [this, end = std::move(motion.end)](HoldMotion::Id id, control::StopCause cause) {
        end(id, cause);
        showNoAction();
    };
    return motion;
}

void RouteRunner::showNoAction() {
    if (acting_) {
        acting_.reset();
        Q_EMIT routeChanged();
    }
}

void RouteRunner::fail(const Error& error) {
    const int row = acting_ ? comingRow() : -1;
    const QString why = whyNot(error);
    Q_EMIT failed(row < 0 ? why : tr("“%1”: %2").arg(document_.waypoints().at(row).name, why));
}

const project::WaypointAction* RouteRunner::acting() const {
    return acting_ ? &*acting_ : nullptr;
}

QVector<QUuid> RouteRunner::idsOf(const QVector<int>& rows) const {
    QVector<QUuid> ids;
    for (const int row : rows) {
        ids << document_.waypoints().at(row).id;
    }
    return ids;
}

void RouteRunner::setRows(const QVector<int>& rows) {
    rows_ = rows;
    endActing();
    route_.setWaypoints(idsOf(rows));
    Q_EMIT routeChanged();
}

void RouteRunner::followRows(const QVector<int>& rows) {
    rows_ = rows;
    route_.follow(idsOf(rows));
    Q_EMIT routeChanged();
}

void RouteRunner::setLoop(bool loop) {
    route_.setLoop(loop);
    Q_EMIT routeChanged();
}

int RouteRunner::comingRow() const {
    return route_.coming() ? rowOf(*route_.coming()) : -1;
}

int RouteRunner::rowOf(int place) const {
    const int row = rows_.value(place, -1);
    return row >= 0 && row < document_.waypoints().size() &&
                   document_.waypoints().at(row).id == route_.at(place)
               ? row
               : -1;
}

std::optional<int> RouteRunner::firstPlace(Way way) const {
    if (way == Way::StepBack) {
        return route_.before();
    }
    return route_.isDone() ? std::optional(0) : route_.coming();
}

QString RouteRunner::obstacle(Way way) const {
    if (route_.size() == 0) {
        return tr("The route has no waypoints. Teach or select waypoints first.");
    }
    const std::optional<int> first = firstPlace(way);
    if (!first) {
        return tr("There is no waypoint before the first waypoint of the route.");
    }
    if (way == Way::Through && route_.isLoop() && route_.size() == 1 && rowOf(0) >= 0 &&
        document_.waypoints().at(rowOf(0)).actions.empty()) {
        return tr("A loop requires at least two waypoints. Select more waypoints, or clear “Loop”.");
    }
    // Do not start a loop that cannot be completed.
    const bool whole = way == Way::Through && route_.isLoop();
    for (int place = whole ? 0 : *first; place <= lastPlace(way); ++place) {
        const int row = rowOf(place);
        if (row < 0) {
            return tr(
                "A waypoint of the route was deleted from the project. Select the waypoints of the route "
                "again.");
        }
        if (const project::Reach& reach = document_.reach(row); !reach.ok()) {
            return tr("“%1”: %2").arg(document_.waypoints().at(row).name, reachAdvice(reach));
        }
    }
    return {};
}

int RouteRunner::lastPlace(Way way) const {
    return way == Way::Through ? route_.size() - 1 : firstPlace(way).value_or(-1);
}

/// Why an action of the route is not possible, as a sentence. Checked only when the button is pressed,
/// because the gripper may change at any time.
QString RouteRunner::actionObstacle(Way way) const {
    if (way == Way::StepBack) {
        return {};
    }
    const bool whole = way == Way::Through && route_.isLoop();
    for (int place = whole ? 0 : *firstPlace(way); place <= lastPlace(way); ++place) {
        const project::Waypoint& point = document_.waypoints().at(rowOf(place));
        for (const project::WaypointAction& action : point.actions) {
            if (const QString why = ActionStep::obstacle(action, actions_.gripper.choice()); !why.isEmpty()) {
                return tr("“%1”: %2").arg(point.name, why);
            }
        }
    }
    return {};
}

/// Prevents the start of a route that leads to a collision. Moves beyond those checked here are checked when
/// they start.
Result<void> RouteRunner::permits(Way way) const {
    std::vector<MoveRequest> moves;
    SessionState from = state_;
    const int first = *firstPlace(way);
    for (int place = first; place <= std::min(lastPlace(way), first + kLookedAt); ++place) {
        const Result<MoveRequest> move = moveTo(place, from);
        if (!move) {
            return move.error();
        }
        moves.push_back(*move);
        from = after(*move, from);
    }
    return port_.permits ? port_.permits(moves) : Result<void>();
}

/// Returns the waypoint at `place` and, with blends, the waypoints after it up to the next stop.
QVector<int> RouteRunner::legFrom(int place, Way way) const {
    QVector<int> leg{place};
    while (way == Way::Through && leg.last() + 1 < route_.size() &&
           document_.waypoints().at(rowOf(leg.last())).blend >= kMinBlend &&
           document_.waypoints().at(rowOf(leg.last())).actions.empty()) {
        leg << leg.last() + 1;
    }
    return leg;
}

Result<MoveRequest> RouteRunner::moveTo(int place, const SessionState& from) const {
    const project::Waypoint& point = document_.waypoints().at(rowOf(place));
    const Result<MoveRequest> move =
        moveRequestFor(document_.robot(), point, document_.frames(), from.q, from.tcpOffset, port_.limits());
    if (!move) {
        return Error{move.error().code, tr("“%1”: %2").arg(point.name, move.error().context), {}};
    }
    return slowedTo(heldSpeed_(), *move, from);
}

Result<MoveRequest> RouteRunner::firstMove(Way way) const {
    if (const QString why = obstacle(way); !why.isEmpty()) {
        return Error{ErrorCode::NoSolution, why, {}};
    }
    return moveTo(*firstPlace(way), state_);
}

Result<std::vector<MoveRequest>> RouteRunner::movesOf(const QVector<int>& leg) const {
    std::vector<MoveRequest> moves;
    SessionState from = state_;
    for (const int place : leg) {
        const Result<MoveRequest> move = moveTo(place, from);
        if (!move) {
            return move.error();
        }
        moves.push_back(*move);
        from = after(*move, from);
    }
    return moves;
}

control::MotionPath RouteRunner::pathOf(const QVector<int>& leg,
                                        const std::vector<MoveRequest>& moves) const {
    std::vector<Eigen::Vector3d> places{state_.tcpPose.position};
    control::MotionPath path;
    for (const MoveRequest& move : moves) {
        places.push_back(after(move, state_).tcpPose.position);
        control::PathEntry entry;
        const bool joint = move.kind == MoveRequest::Kind::MoveJ;
        entry.kind = joint ? control::PathEntry::Kind::MoveJ : control::PathEntry::Kind::MoveL;
        entry.target = joint ? control::PathEntry::Target(move.q) : control::PathEntry::Target(move.pose);
        entry.speed = move.speed;
        entry.acceleration = move.acceleration;
        path.push_back(entry);
    }
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const double room = kBlendShare * std::min((places[i + 1] - places[i]).norm(),
                                                   (places[i + 2] - places[i + 1]).norm());
        const double blend =
            std::min(document_.waypoints().at(rowOf(leg[static_cast<qsizetype>(i)])).blend, room);
        path[i].blend = blend < kMinBlend ? 0 : blend;
    }
    return path;
}

void RouteRunner::headFor(int place, Way way) {
    if (way == Way::StepBack) {
        route_.headBackTo(place);
    } else {
        route_.headOnTo(place);
    }
    Q_EMIT routeChanged();
}

bool RouteRunner::isThere(int place) const {
    constexpr double kSamePlace = 0.002;  // [rad]
    const Result<MoveRequest> move = moveTo(place, state_);
    return move && (move->q.values - state_.q.values).cwiseAbs().maxCoeff() < kSamePlace;
}

bool RouteRunner::isActingAt(int place) const {
    return !actingAt_.isNull() && route_.at(place) == actingAt_;
}

void RouteRunner::endActing() {
    actingAt_ = QUuid();
    done_.clear();
    acting_.reset();
}

void RouteRunner::finishStep(Way way) {
    if (acting_) {
        done_.push_back(*acting_);
        acting_.reset();
    }
    if (leg_.isEmpty()) {
        return;
    }
    const int place = leg_.last();
    leg_.clear();
    if (way == Way::StepBack) {
        route_.reach(place);
    } else {
        route_.headOnTo(place);  // a path may end before its last target is reported
        if (!isActingAt(place)) {
            actingAt_ = route_.at(place);
            done_.clear();
        }
    }
    Q_EMIT routeChanged();
}

/// The next action of the waypoint that the arm has reached; null if all actions are complete.
const project::WaypointAction* RouteRunner::nextAction() {
    const project::WaypointActions& all = document_.waypoints().at(rowOf(*route_.coming())).actions;
    // If the actions were edited, execute all of them again.
    if (done_.size() > all.size() || !std::equal(done_.begin(), done_.end(), all.begin())) {
        done_.clear();
    }
    return done_.size() < all.size() ? &all[done_.size()] : nullptr;
}

Result<std::unique_ptr<SequenceStep>> RouteRunner::nextStep(Way way) {
    finishStep(way);
    if (way != Way::StepBack && route_.coming() && isActingAt(*route_.coming())) {
        const int place = *route_.coming();
        if (const project::WaypointAction* action = nextAction()) {
            if (legs_ == 0 && !isThere(place)) {
                return nextLeg(way);
            }
            ++legs_;
            acting_ = *action;
            Q_EMIT routeChanged();
            return std::unique_ptr<SequenceStep>(std::make_unique<ActionStep>(actions_, state_, *action));
        }
        endActing();
        route_.reach(place);
        Q_EMIT routeChanged();
    }
    return nextLeg(way);
}

Result<std::unique_ptr<SequenceStep>> RouteRunner::nextLeg(Way way) {
    const std::optional<int> place = way == Way::StepBack ? route_.before() : route_.coming();
    if (!place || (way != Way::Through && legs_ > 0)) {
        return std::unique_ptr<SequenceStep>();
    }
    const QVector<int> leg = legFrom(*place, way);
    const Result<std::vector<MoveRequest>> moves = movesOf(leg);
    if (!moves) {
        return moves.error();
    }
    ++legs_;
    leg_ = leg;
    const auto onMove = [this, way](int move) { headFor(leg_.at(move), way); };
    return leg.size() == 1
               ? std::unique_ptr<SequenceStep>(std::make_unique<MoveStep>(port_, moves->front(), onMove))
               : std::make_unique<MoveStep>(port_, pathOf(leg, *moves), onMove);
}

HoldBounds RouteRunner::bounds(Way way) const {
    const std::optional<int> first = firstPlace(way);
    if (!first) {
        return {};
    }
    const int last = lastPlace(way);
    double seconds = 0;
    double linear = 0;   // [m/s]
    double angular = 0;  // [rad/s]
    SessionState from = state_;
    int looked = 0;
    for (int place = *first; place <= last && looked < kLookedAt; ++place, ++looked) {
        const Result<MoveRequest> move = moveTo(place, from);
        if (!move) {
            break;
        }
        seconds += moveSeconds(*move, from);
        (move->kind == MoveRequest::Kind::MoveL ? linear : angular) =
            std::max(move->kind == MoveRequest::Kind::MoveL ? linear : angular, move->speed);
        from = after(*move, from);
    }
    double acting = 0;  // [s]
    for (int place = *first; way != Way::StepBack && place <= last; ++place) {
        const int row = rowOf(place);
        for (const project::WaypointAction& action :
             row < 0 ? project::WaypointActions() : document_.waypoints().at(row).actions) {
            acting += ActionStep::longestOf(action);
        }
    }
    HoldBounds bounds;
    bounds.holdTimeoutNs = HoldBounds::holdTimeoutAt(linear, angular);
    // A loop has no maximum duration.
    if (way != Way::Through || !route_.isLoop()) {
        // The remaining moves may take up to twice as long as the examined moves.
        const int others = std::max(0, last - *first + 1 - looked);
        bounds.longestNs = HoldBounds::longestOf(
            acting + (looked == 0 ? 0 : seconds * (1 + 2.0 * static_cast<double>(others) / looked)));
    }
    return bounds;
}

}  // namespace tiller

#include "moc_route_runner.cpp"
