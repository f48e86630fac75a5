// SPDX-License-Identifier: MIT
#include "robot/station/link/detail/move_guard.h"

#include <algorithm>
#include <optional>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/station/text/move_words.h"

namespace tiller {
namespace {

/// The joint positions of a target. Empty if the target is unreachable, because the controller then refuses
/// it.
std::optional<JointPositions> jointsOf(const DhParameters& dh, const Pose& tcpOffset,
                                       const control::PathEntry::Target& target, const JointPositions& from) {
    if (const auto* q = std::get_if<JointPositions>(&target)) {
        return *q;
    }
    return kinematics::inverseNearest(dh, std::get<Pose>(target), tcpOffset, from);
}

/// The first position on this path at this TCP distance from the corner.
JointPositions positionAt(const DhParameters& dh, const Pose& tcpOffset,
                          std::span<const JointPositions> fromCorner, double distance) {
    constexpr int kParts = 16;  // number of subdivisions between two positions
    const Eigen::Vector3d corner = kinematics::forwardTcp(dh, fromCorner.front(), tcpOffset).position;
    for (std::size_t i = 0; i + 1 < fromCorner.size(); ++i) {
        for (int part = 1; part <= kParts; ++part) {
            const double share = static_cast<double>(part) / kParts;
            const JointPositions q(
                Vector6(fromCorner[i].values + share * (fromCorner[i + 1].values - fromCorner[i].values)));
            if ((kinematics::forwardTcp(dh, q, tcpOffset).position - corner).norm() >= distance) {
                return q;
            }
        }
    }
    return fromCorner.back();
}

}  // namespace

void MoveGuard::setSurroundings(const collision::CellSurroundings& cell) {
    cell_ = cell;
    check_.reset();
}

Result<void> MoveGuard::permitsAny() const {
    if (cell_.unplaced.empty()) {
        return {};
    }
    return refusal(unplacedText(cell_.unplaced.front()));
}

bool MoveGuard::follow(const SessionState& state) {
    const RobotModel arm = state.arm();
    if (check_ != nullptr && arm.id == arm_.id && arm.dh == arm_.dh && state.tcpOffset == tcpOffset_) {
        return false;
    }
    arm_ = arm;
    tcpOffset_ = state.tcpOffset;
    check_ =
        std::make_shared<collision::CollisionCheck>(arm_, collision::ToolBody{tcpOffset_, cell_.toolRadius},
                                                    cell_.around, cell_.safetyDistance, &neverMeeting_);
    return true;
}

Result<void> MoveGuard::permit(const SessionState& state, std::span<const MoveRequest> moves) const {
    std::vector<Leg> legs;
    for (const MoveRequest& move : moves) {
        const bool linear = move.kind == MoveRequest::Kind::MoveL;
        legs.push_back(
            {linear ? control::PathEntry::Target(move.pose) : control::PathEntry::Target(move.q), linear, 0});
        legs.back().point = static_cast<int>(legs.size());
    }
    return permit(state.q, legs);
}

Result<void> MoveGuard::permit(const SessionState& state, std::span<const JointPositions> way) const {
    if (const Result<void> permitted = permitsAny(); !permitted || check_ == nullptr) {
        return permitted;
    }
    std::vector<JointPositions> whole{state.q};
    whole.insert(whole.end(), way.begin(), way.end());
    const auto limit = collision::collisionOn(arm_, *check_, tcpOffset_, whole);
    return limit ? Result<void>(refusal(limitText(*limit, check_->surroundings()))) : Result<void>();
}

Error MoveGuard::refusal(const QString& reason) {
    return {ErrorCode::NoSolution, RobotSession::tr("Move refused: %1.").arg(reason), {}};
}

Result<void> MoveGuard::permit(const SessionState& state, const control::MotionPath& path) const {
    std::vector<Leg> legs;
    int point = 0;
    for (const control::PathEntry& entry : path) {
        ++point;
        const bool linear = entry.kind != control::PathEntry::Kind::MoveJ;
        if (entry.via) {
            legs.push_back(
                {*entry.via, linear, 0, point});  // an arc is approximated by two lines through `via`
        }
        legs.push_back({entry.target, linear, entry.blend, point});
    }
    return permit(state.q, legs);
}

Result<void> MoveGuard::permit(const JointPositions& start, const std::vector<Leg>& legs) const {
    if (const Result<void> permitted = permitsAny(); !permitted || check_ == nullptr) {
        return permitted;
    }
    JointPositions from = start;
    std::vector<JointPositions> before;
    double blend = 0;
    const int points = legs.empty() ? 0 : legs.back().point;
    int point = 0;
    const auto examine = [&](const collision::Move& move) -> std::optional<Error> {
        const collision::MoveReport report = collision::examineMove(arm_, *check_, tcpOffset_, move, 1);
        before = report.way;
        const bool collides = report.limit && report.limit->kind == collision::MoveLimit::Kind::Collision;
        if (!collides) {
            return std::nullopt;
        }
        const QString reason = limitText(*report.limit, check_->surroundings());
        return refusal(
            points > 1
                ? RobotSession::tr("while moving to point %1 of %2: %3").arg(point).arg(points).arg(reason)
                : reason);
    };
    for (const Leg& leg : legs) {
        point = leg.point;
        const auto to = jointsOf(arm_.dh, tcpOffset_, leg.target, from);
        if (!to) {
            break;
        }
        const std::vector<JointPositions> reached(before.rbegin(), before.rend());
        if (const auto error = examine({from, *to, leg.linear})) {
            return *error;
        }
        const std::vector<JointPositions> way = before;
        if (blend > 0 && reached.size() > 1 && way.size() > 1) {
            // The controller blends the corner between the two segments.
            const collision::Move corner{positionAt(arm_.dh, tcpOffset_, reached, blend),
                                         positionAt(arm_.dh, tcpOffset_, way, blend), false};
            if (const auto error = examine(corner)) {
                return *error;
            }
        }
        before = way;
        from = way.back();
        blend = leg.blend;
    }
    return {};
}

}  // namespace tiller
