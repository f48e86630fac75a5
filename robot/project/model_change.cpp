// SPDX-License-Identifier: MIT
#include "robot/project/model_change.h"

#include <algorithm>
#include <vector>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/project/reachability.h"
#include "robot/project/relative_move.h"

namespace tiller::project {
namespace {

/// Stores the pose in the waypoint's frame. If the frame is missing, the waypoint does not change.
void setPlace(Waypoint& point, const Pose& T_base_tcp, const FrameList& frames) {
    point = taughtAt(point, point.joints, T_base_tcp, point.tcpOffset, frames).value_or(point);
}

class Changer {
public:
    Changer(const RobotModel& from, const RobotModel& to, const FrameList& frames)
        : from_(from), to_(to), frames_(frames) {}

    /// Returns  false if the new arm cannot reach the pose
    bool keepPose(Waypoint& point) const {
        const std::optional<Pose> place = placeOf(point, from_, frames_);
        if (!place) {
            return true;  // the user interface shows the missing frame
        }
        if (point.priority == TargetKind::Joints) {
            setPlace(point, *place, frames_);
        }
        return solve(point, *place);
    }

    void keepJoints(Waypoint& point) const {
        // If the pose is the target, use its current joint positions, which may differ from the taught ones.
        if (const Reach now = reach(from_, point, frames_); now.ok()) {
            point.joints = now.q;
        }
        setPlace(point, kinematics::forwardTcp(to_.dh, point.joints, point.tcpOffset), frames_);
    }

    /// Recomputes the pose of a pattern's waypoint, and its joint positions for the new arm.
    bool layAgain(Waypoint& point, const Pattern& pattern) const {
        point.pose = poseAt(pattern, point.place);
        point.tcpOffset = pattern.first.tcpOffset;
        const std::optional<Pose> place = poseInBase(point, frames_);
        return !place || solve(point, *place);
    }

    /// Returns  true if the new arm can move the flange to the same pose
    bool keepFlange(JointPositions& q) const {
        const auto solved =
            kinematics::inverseNearest(to_.dh, kinematics::forwardTcp(from_.dh, q, {}), {}, q);
        q = solved.value_or(q);
        return solved.has_value();
    }

    /// Like keepFlange(), for a path. Fails if a joint step is much larger than in the taught path, which
    /// indicates another configuration.
    bool keepPath(RecordedPath& path) const {
        constexpr double kJump =
            0.5;  // [rad] between two points; more indicates another configuration or a singularity
        JointPositions before;
        JointPositions last;
        for (std::size_t i = 0; i < path.points.size(); ++i) {
            JointPositions& q = path.points[i].q;
            const JointPositions taught = q;
            const auto solved =
                kinematics::inverseNearest(to_.dh, kinematics::forwardTcp(from_.dh, taught, path.tcpOffset),
                                           path.tcpOffset, i == 0 ? taught : last);
            if (!solved) {
                return false;
            }
            const double moved = (solved->values - last.values).cwiseAbs().maxCoeff();
            const double asTaught = (taught.values - before.values).cwiseAbs().maxCoeff();
            if (i > 0 && moved > asTaught + kJump) {
                return false;
            }
            before = taught;
            last = q = *solved;
        }
        return true;
    }

private:
    bool solve(Waypoint& point, const Pose& T_base_tcp) const {
        const auto q = kinematics::inverseNearest(to_.dh, T_base_tcp, point.tcpOffset, point.joints);
        point.joints = q.value_or(point.joints);
        if (!q) {
            point.priority = TargetKind::Pose;
        }
        return q.has_value();
    }

    const RobotModel& from_;
    const RobotModel& to_;
    const FrameList& frames_;
};

/// The corners move with the first position, which preserves the shape.
Pattern movedWith(const Pattern& before, const Waypoint& first) {
    Pattern after = before;
    after.first = first;
    if (first.pose == before.first.pose) {
        return after;  // exactly equal, because the waypoints of the pattern are computed from it
    }
    const Eigen::Isometry3d move =
        first.pose.transform() * before.first.pose.transform().inverse(Eigen::Isometry);
    after.columnEnd = move * before.columnEnd;
    after.rowEnd = move * before.rowEnd;
    return after;
}

}  // namespace

bool isSameGeometry(RobotModelId a, RobotModelId b) {
    return a == b || robotModel(a).dh == robotModel(b).dh;
}

bool hasTaughtPlaces(const Project& project) {
    return !project.waypoints.isEmpty() || !project.positions.list.isEmpty() || !project.patterns.isEmpty() ||
           !project.paths.isEmpty();
}

bool isOfOtherModel(const Project& project, RobotModelId connected) {
    return project.robot && !isSameGeometry(*project.robot, connected) && hasTaughtPlaces(project);
}

ModelChange changeModel(const Project& project, const RobotModel& from, const RobotModel& to, Keep keep) {
    ModelChange change{project, {}, {}};
    Project& after = change.project;
    after.robot = to.id;
    const Changer changer(from, to, project.frames);
    const bool poses = keep == Keep::Poses;

    for (std::size_t i = 0; i < after.patterns.size(); ++i) {
        const Pattern& before = project.patterns.at(i);
        Waypoint first = before.first;
        if (poses) {
            (void)changer.keepPose(first);  // the waypoints of the pattern show whether it is reachable
        } else {
            changer.keepJoints(first);
        }
        after.patterns.replace(i, movedWith(before, first));
    }
    for (int row = 0; row < after.waypoints.size(); ++row) {
        Waypoint point = after.waypoints.at(row);
        const Pattern* before = project.patterns.find(point.place.pattern);
        const Pattern* pattern = after.patterns.find(point.place.pattern);
        bool reached = true;
        if (poses) {
            reached = changer.keepPose(point);
        } else if (before != nullptr && pattern != nullptr && isWhereLaid(point, *before)) {
            reached = changer.layAgain(point, *pattern);
        } else {
            changer.keepJoints(point);
        }
        if (!reached) {
            change.unreachable << point.name;
        }
        after.waypoints.replace(row, std::move(point));
    }
    if (!poses) {
        return change;
    }
    for (std::size_t i = after.positions.list.size(); i-- > 0;) {
        NamedPosition position = after.positions.list.at(i);
        if (changer.keepFlange(position.joints)) {
            after.positions.list.replace(i, std::move(position));
            continue;
        }
        change.removed.prepend(position.name);
        if (after.positions.home == position.id) {
            after.positions.home = QUuid();
        }
        after.positions.list.remove(i);
    }
    QStringList removedPaths;
    for (std::size_t i = after.paths.size(); i-- > 0;) {
        RecordedPath path = after.paths.at(i);
        if (changer.keepPath(path)) {
            after.paths.replace(i, std::move(path));
        } else {
            removedPaths.prepend(path.name);
            after.paths.remove(i);
        }
    }
    change.removed += removedPaths;
    return change;
}

}  // namespace tiller::project
