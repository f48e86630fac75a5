// SPDX-License-Identifier: MIT
#include "robot/station/document/project_check.h"

#include <array>
#include <optional>

#include "robot/station/document/cell_surroundings.h"

namespace tiller {
namespace {

using Kind = ProjectFinding::Kind;

/// The pair of bodies with the largest violation of the safety distance; empty without a violation.
std::optional<collision::Contact> closest(const collision::CollisionCheck& check, const JointPositions& q) {
    std::optional<collision::Contact> worst;
    double missing = collision::kSafetyTolerance;
    const collision::CollisionCheck::Placement placement = check.place(q);
    for (const collision::CollisionCheck::Pair& pair : check.pairs()) {
        const double distance = check.distance(pair, placement);
        if (pair.margin - distance > missing) {
            missing = pair.margin - distance;
            worst = {pair.with, pair.link, pair.otherLink, 0, q, distance};
        }
    }
    return worst;
}

class Checker {
public:
    Checker(const project::Project& project, const RobotModel& robot)
        : project_(project), robot_(robot), cell_(surroundingsOf(project)) {}

    std::vector<ProjectFinding> run() {
        for (const collision::UnplacedObject& object : cell_.unplaced) {
            ProjectFinding finding;
            finding.kind = Kind::Unplaced;
            finding.row = -1;
            finding.object = object;
            findings_.push_back(finding);
        }
        std::optional<JointPositions> from;
        for (int row = 0; row < project_.waypoints.size(); ++row) {
            from = checkWaypoint(row, from);
        }
        for (std::size_t row = 0; row < project_.paths.size(); ++row) {
            checkPath(static_cast<int>(row), project_.paths.at(row));
        }
        return std::move(findings_);
    }

private:
    /// Returns  the joint positions at the waypoint; empty if it is unreachable
    std::optional<JointPositions> checkWaypoint(int row, const std::optional<JointPositions>& from) {
        const project::Waypoint& point = project_.waypoints.at(row);
        ProjectFinding finding;
        finding.row = row;
        finding.reach = project::reach(robot_, point, project_.frames);
        if (!finding.reach.ok()) {
            findings_.push_back(finding);
            return std::nullopt;
        }
        const JointPositions q = finding.reach.q;
        const collision::CollisionCheck& check = checkWith(point.tcpOffset);
        if (const auto contact = closest(check, q)) {
            finding.kind = Kind::TooClose;
            finding.contact = *contact;
            findings_.push_back(finding);
        }
        if (from) {
            const collision::Move move{*from, q, point.move == project::MoveKind::Linear, point.speed(),
                                       point.acceleration()};
            const auto report = collision::examineMove(robot_, check, point.tcpOffset, move, 1);
            if (report.limit) {
                finding.kind = report.limit->ends() ? Kind::Blocked : Kind::Slow;
                finding.limit = *report.limit;
                findings_.push_back(finding);
            }
        }
        return q;
    }

    void checkPath(int row, const project::RecordedPath& path) {
        std::vector<JointPositions> positions;
        for (const project::PathPoint& point : path.points) {
            positions.push_back(point.q);
        }
        if (positions.empty()) {
            return;
        }
        const collision::CollisionCheck& check = checkWith(path.tcpOffset);
        if (const auto limit = collision::collisionOn(robot_, check, path.tcpOffset, positions)) {
            ProjectFinding finding;
            finding.kind = Kind::RecordedPath;
            finding.row = row;
            finding.limit = *limit;
            findings_.push_back(finding);
        }
    }

    const collision::CollisionCheck& checkWith(const Pose& tcpOffset) {
        if (!check_ || !(tcpOffset == tcpOffset_)) {
            tcpOffset_ = tcpOffset;
            check_.emplace(robot_, collision::ToolBody{tcpOffset, cell_.toolRadius}, cell_.around,
                           cell_.safetyDistance);
        }
        return *check_;
    }

    const project::Project& project_;
    const RobotModel& robot_;
    const collision::CellSurroundings cell_;
    Pose tcpOffset_;
    std::optional<collision::CollisionCheck> check_;  ///< valid for tcpOffset_
    std::vector<ProjectFinding> findings_;
};

}  // namespace

std::vector<ProjectFinding> checkProject(const project::Project& project, const RobotModel& robot) {
    return Checker(project, robot).run();
}

}  // namespace tiller
