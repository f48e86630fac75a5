// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/go_through.h"

#include <algorithm>
#include <utility>

#include "robot/kinematics/arm_kinematics.h"
#include "widgets/project/project_document.h"
#include "widgets/session/texts.h"
#include "widgets/waypoints/waypoint_model.h"
#include "widgets/waypoints/waypoint_motion.h"

namespace tiller {
namespace {

/// Two blends may not overlap: each ends before the middle of the way [part of the way].
constexpr double kBlendShare = 0.49;
/// Less is no blend [m].
constexpr double kLeastBlend = 1e-4;
/// So many ways are looked at closely to know how long all of them take.
constexpr int kLookedAt = 32;

/// Where the arm is after the move.
SessionState after(const MoveRequest& move, SessionState state) {
    state.q = move.q;
    state.tcpPose = kinematics::forwardTcp(robotModel(state.model).dh, move.q, state.tcpOffset);
    return state;
}

}  // namespace

GoThrough::GoThrough(const MotionPort& port, const ProjectDocument& document, const SessionState& state,
                     const std::function<HeldSpeed()>& heldSpeed, QObject* parent)
    : QObject(parent)
    , port_(port)
    , document_(document)
    , state_(state)
    , heldSpeed_(heldSpeed)
    , through_(
          port.stops, [this] { return nextStep(Way::Through); },
          [this](const Error& error) { Q_EMIT failed(whyNot(error)); })
    , stepOn_(
          port.stops, [this] { return nextStep(Way::StepOn); },
          [this](const Error& error) { Q_EMIT failed(whyNot(error)); })
    , stepBack_(
          port.stops, [this] { return nextStep(Way::StepBack); },
          [this](const Error& error) { Q_EMIT failed(whyNot(error)); }) {}

QString GoThrough::whyNot(const Error& error) {
    // These are sentences already.
    const bool said = error.code == ErrorCode::NoSolution || error.code == ErrorCode::Cancelled;
    return said && error.controllerMessage.isEmpty() ? error.context : texts::errorText(error);
}

GoThrough::~GoThrough() = default;

HoldMotion GoThrough::motion(Way way) {
    HeldSequence& sequence = way == Way::Through ? through_ : way == Way::StepOn ? stepOn_ : stepBack_;
    HoldMotion motion = sequence.motion([this, way] { return bounds(way); });
    motion.begin = [this, way, begin = std::move(motion.begin)]() -> Result<HoldMotion::Id> {
        if (way != Way::StepBack && route_.isDone()) {
            route_.beginAnew();
        }
        if (const QString why = obstacle(way); !why.isEmpty()) {
            return Error{ErrorCode::NoSolution, why, {}};
        }
        leg_.clear();
        legs_ = 0;
        return begin();
    };
    return motion;
}

QVector<QUuid> GoThrough::idsOf(const QVector<int>& rows) const {
    QVector<QUuid> ids;
    for (const int row : rows) {
        ids << document_.waypoints().at(row).id;
    }
    return ids;
}

void GoThrough::setRows(const QVector<int>& rows) {
    rows_ = rows;
    route_.setWaypoints(idsOf(rows));
    Q_EMIT routeChanged();
}

void GoThrough::followRows(const QVector<int>& rows) {
    rows_ = rows;
    route_.follow(idsOf(rows));
    Q_EMIT routeChanged();
}

void GoThrough::setLoop(bool loop) {
    route_.setLoop(loop);
    Q_EMIT routeChanged();
}

int GoThrough::comingRow() const {
    return route_.coming() ? rowOf(*route_.coming()) : -1;
}

int GoThrough::rowOf(int place) const {
    const int row = rows_.value(place, -1);
    return row >= 0 && row < document_.waypoints().size() &&
                   document_.waypoints().at(row).id == route_.at(place)
               ? row
               : -1;
}

std::optional<int> GoThrough::firstPlace(Way way) const {
    if (way == Way::StepBack) {
        return route_.before();
    }
    return route_.isDone() ? std::optional(0) : route_.coming();
}

QString GoThrough::obstacle(Way way) const {
    if (route_.size() == 0) {
        return tr("There are no waypoints to go through. Teach some, or select them.");
    }
    const std::optional<int> first = firstPlace(way);
    if (!first) {
        return tr("There is no waypoint before this one.");
    }
    // What cannot be gone to its end is not begun.
    const bool whole = way == Way::Through && route_.isLoop();
    const int last = way == Way::Through ? route_.size() - 1 : *first;
    for (int place = whole ? 0 : *first; place <= last; ++place) {
        const int row = rowOf(place);
        if (row < 0) {
            return tr("A waypoint of the way is not in this project any more.");
        }
        if (const project::Reach& reach = document_.reach(row); !reach.ok()) {
            return tr("“%1”: %2").arg(document_.waypoints().at(row).name, WaypointModel::reachAdvice(reach));
        }
    }
    return {};
}

/// The places that are gone to without a stop between them.
QVector<int> GoThrough::legFrom(int place, Way way) const {
    QVector<int> leg{place};
    while (way == Way::Through && leg.last() + 1 < route_.size() &&
           document_.waypoints().at(rowOf(leg.last())).blend >= kLeastBlend) {
        leg << leg.last() + 1;
    }
    return leg;
}

Result<MoveRequest> GoThrough::moveTo(int place, const SessionState& from) const {
    const project::Waypoint& point = document_.waypoints().at(rowOf(place));
    const Result<MoveRequest> move =
        moveRequestFor(document_.robot(), point, document_.frames(), from.q, from.tcpOffset, port_.limits());
    if (!move) {
        return Error{move.error().code, tr("“%1”: %2").arg(point.name, move.error().context), {}};
    }
    return slowedTo(heldSpeed_(), *move, from);
}

Result<MoveRequest> GoThrough::firstMove(Way way) const {
    if (const QString why = obstacle(way); !why.isEmpty()) {
        return Error{ErrorCode::NoSolution, why, {}};
    }
    return moveTo(*firstPlace(way), state_);
}

Result<std::vector<MoveRequest>> GoThrough::movesOf(const QVector<int>& leg) const {
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

control::MotionPath GoThrough::pathOf(const QVector<int>& leg, const std::vector<MoveRequest>& moves) const {
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
        path[i].blend = blend < kLeastBlend ? 0 : blend;
    }
    return path;
}

void GoThrough::headFor(int place, Way way) {
    if (way == Way::StepBack) {
        route_.headBackTo(place);
    } else {
        route_.headOnTo(place);
    }
    Q_EMIT routeChanged();
}

Result<std::unique_ptr<SequenceStep>> GoThrough::nextStep(Way way) {
    if (!leg_.isEmpty()) {
        route_.reach(leg_.last());
        leg_.clear();
        Q_EMIT routeChanged();
    }
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
    const auto told = [this, way](int move) { headFor(leg_.at(move), way); };
    return leg.size() == 1
               ? std::unique_ptr<SequenceStep>(std::make_unique<MoveStep>(port_, moves->front(), told))
               : std::make_unique<MoveStep>(port_, pathOf(leg, *moves), told);
}

HoldBounds GoThrough::bounds(Way way) const {
    const std::optional<int> first = firstPlace(way);
    if (!first) {
        return {};
    }
    const int last = way == Way::Through ? route_.size() - 1 : *first;
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
    HoldBounds bounds;
    bounds.silenceNs = HoldRules::silenceAt(linear, angular);
    // A loop has no end of its own.
    if (way != Way::Through || !route_.isLoop()) {
        // Those that were not looked at may take twice as long as these.
        const int others = std::max(0, last - *first + 1 - looked);
        bounds.longestNs = HoldBounds::longestOf(
            looked == 0 ? 0 : seconds * (1 + 2.0 * static_cast<double>(others) / looked));
    }
    return bounds;
}

}  // namespace tiller

#include "moc_go_through.cpp"
