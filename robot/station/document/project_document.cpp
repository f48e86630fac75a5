// SPDX-License-Identifier: MIT
#include "robot/station/document/project_document.h"

#include <QHash>
#include <QSet>
#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "robot/project/waypoint_revision.h"
#include "robot/station/document/project_edits.h"

namespace tiller {

ProjectDocument::ProjectDocument(QObject* parent)
    : QObject(parent)
    , robot_(robotModel(RobotModelId::UR5e))
    , author_(qEnvironmentVariable("USER", qEnvironmentVariable("USERNAME"))) {}

ProjectDocument::~ProjectDocument() = default;

void ProjectDocument::push(std::unique_ptr<ProjectEdit> edit) {
    edit->apply(*this);
}

void ProjectDocument::setRobot(const RobotModel& connected) {
    isConnected_ = true;
    useRobot(connected);
}

void ProjectDocument::clearRobot() {
    isConnected_ = false;
    connectedModel_.reset();
    useRobot(robotModel(project_.robot.value_or(RobotModelId::UR5e)));
}

void ProjectDocument::useRobot(const RobotModel& robot) {
    if (robot_.id == robot.id && robot_.dh == robot.dh) {
        return;
    }
    robot_ = robot;
    refreshReach();
    notifyAllChanged();
}

void ProjectDocument::adoptRobot(RobotModelId connected) {
    connectedModel_ = connected;
    if (project_.robot == connected || (project_.robot && project::hasTaughtPlaces(project_))) {
        return;
    }
    adoptions_.push_back({historyIndex(), project_.robot});
    project_.robot = connected;
}

void ProjectDocument::restoreRobot() {
    const std::optional<RobotModelId> now = project_.robot;
    for (; !adoptions_.empty() && historyIndex() < adoptions_.back().index; adoptions_.pop_back()) {
        project_.robot = adoptions_.back().before;
    }
    if (connectedModel_) {
        adoptRobot(*connectedModel_);
    }
    if (project_.robot != now) {
        notifyPart(project_.robot);
    }
}

void ProjectDocument::setProject(project::Project project) {
    Q_EMIT projectAboutToBeReplaced();
    project_ = std::move(project);
    if (!isConnected_ && project_.robot) {
        robot_ = robotModel(*project_.robot);
    }
    refreshReach();
    adoptions_.clear();
    Q_EMIT projectReplaced();
    clearHistory();
    Q_EMIT framesChanged();
    Q_EMIT toolingChanged();
    Q_EMIT positionsChanged();
    Q_EMIT patternsChanged();
    Q_EMIT cellChanged();
    Q_EMIT pathsChanged();
    Q_EMIT documentChanged();
}

project::Reach ProjectDocument::reachOf(const project::Waypoint& point) const {
    if (isOfOtherModel()) {
        return {project::Reach::Obstacle::OtherModel, point.joints};
    }
    return project::reach(robot_, point, frames());
}

void ProjectDocument::refreshReach() {
    reach_.clear();
    for (const project::Waypoint& point : waypoints()) {
        reach_.push_back(reachOf(point));
    }
}

void ProjectDocument::notifyAllChanged() {
    if (!waypoints().isEmpty()) {
        Q_EMIT waypointsChanged(0, waypoints().size() - 1);
    }
}

// ---- undo and redo ---------------------------------------------------------------------------------

namespace {

/// ID of the first entry that was added or changed.
template <class List>
QUuid firstOther(const List& before, const List& after) {
    for (const auto& now : after) {
        bool same = false;
        for (const auto& then : before) {
            same = same || then == now;
        }
        if (!same) {
            return now.id;
        }
    }
    return {};
}

ProjectStep stepBetween(const project::Project& before, const project::Project& after) {
    ProjectStep step;
    if (!(before.frames == after.frames)) {
        step.part = ProjectPart::Frames;
        step.id = firstOther(before.frames, after.frames);
    } else if (!(before.waypoints == after.waypoints) || !(before.patterns == after.patterns) ||
               !(before.paths == after.paths) || before.robot != after.robot) {
        step.id = firstOther(before.waypoints, after.waypoints);
    } else if (!(before.tooling.tools == after.tooling.tools) ||
               before.tooling.activeTool != after.tooling.activeTool) {
        step.part = ProjectPart::Tcps;
        step.id = firstOther(before.tooling.tools, after.tooling.tools);
    } else if (!(before.tooling == after.tooling)) {
        step.part = ProjectPart::Payloads;
        step.id = firstOther(before.tooling.payloads, after.tooling.payloads);
    } else if (!(before.positions == after.positions)) {
        step.part = ProjectPart::Positions;
        step.id = firstOther(before.positions.list, after.positions.list);
    } else if (!(before.programs == after.programs)) {
        step.part = ProjectPart::Programs;
        step.id = firstOther(before.programs, after.programs);
    } else {
        step.part = ProjectPart::Cell;
    }
    return step;
}

}  // namespace

void ProjectDocument::finishStep(const project::Project& before, bool undone, const QString& text) {
    restoreRobot();
    ProjectStep step = stepBetween(before, project_);
    step.undone = undone;
    step.text = text;
    Q_EMIT stepTaken(step);
}

// ---- manual edits ----------------------------------------------------------------------------------

void ProjectDocument::insertWaypoints(int row, const std::vector<project::Waypoint>& waypoints,
                                      const QString& text) {
    if (!waypoints.empty()) {
        push(std::make_unique<InsertWaypoints>(std::clamp(row, 0, project_.waypoints.size()), waypoints,
                                               text));
    }
}

void ProjectDocument::removeWaypoints(QList<int> rows) {
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    rows.removeIf([this](int row) { return row < 0 || row >= waypoints().size(); });
    if (rows.isEmpty()) {
        return;
    }
    const QString text = rows.size() == 1 ? tr("Delete “%1”").arg(waypoints().at(rows.first()).name)
                                          : tr("Delete %n waypoints", nullptr, static_cast<int>(rows.size()));
    beginGroup(text);
    forgetPlaces(rows, text);
    push(std::make_unique<RemoveWaypoints>(rows, text));
    endGroup();
}

void ProjectDocument::changeWaypoint(int row, const project::Waypoint& waypoint, const QString& text) {
    changeWaypoints({row}, {waypoint}, text);
}

void ProjectDocument::changeWaypoints(const QList<int>& rows, const std::vector<project::Waypoint>& after,
                                      const QString& text) {
    QVector<int> changedRows;
    std::vector<project::Waypoint> changed;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const int row = rows[static_cast<int>(i)];
        if (!(waypoints().at(row) == after[i])) {
            changedRows.append(row);
            changed.push_back(after[i]);
        }
    }
    if (changed.empty()) {
        return;
    }
    beginGroup(text);
    pushChanges(changedRows, changed, text);
    followCorners(changed, text);
    endGroup();
}

void ProjectDocument::pushChanges(const QVector<int>& rows, std::vector<project::Waypoint> after,
                                  const QString& text) {
    if (rows.isEmpty()) {
        return;
    }
    const QDateTime now = QDateTime::currentDateTimeUtc();
    std::vector<project::Waypoint> before;
    for (std::size_t i = 0; i < after.size(); ++i) {
        before.push_back(waypoints().at(rows[static_cast<int>(i)]));
        after[i] = project::withRevision(std::move(after[i]), before.back(), now, author_, text);
    }
    push(std::make_unique<ChangeWaypoints>(std::move(before), std::move(after), text));
}

void ProjectDocument::moveWaypointsBefore(const QList<int>& rows, int before) {
    QVector<QUuid> front;
    QVector<QUuid> moved;
    QVector<QUuid> back;
    for (int row = 0; row < waypoints().size(); ++row) {
        const QUuid id = waypoints().at(row).id;
        (rows.contains(row) ? moved : row < before ? front : back).append(id);
    }
    pushOrder(front + moved + back, tr("Change order"));
}

void ProjectDocument::pushOrder(const QVector<QUuid>& after, const QString& text) {
    QVector<QUuid> before;
    for (const project::Waypoint& point : waypoints()) {
        before.append(point.id);
    }
    if (after != before) {
        push(std::make_unique<ReorderWaypoints>(before, after, text));
    }
}

void ProjectDocument::insertFrame(int row, const project::Frame& frame, const QString& text) {
    project::FrameList after = frames();
    after.insert(static_cast<std::size_t>(std::clamp(row, 0, static_cast<int>(after.size()))), frame);
    pushFrames(after, text);
}

void ProjectDocument::changeFrame(int row, const project::Frame& frame, const QString& text) {
    project::FrameList after = frames();
    after.replace(static_cast<std::size_t>(row), frame);
    if (!(after == frames())) {
        pushFrames(after, text);
    }
}

void ProjectDocument::removeFrame(int row) {
    const project::Frame frame = frames().at(static_cast<std::size_t>(row));
    project::FrameList after = frames();
    after.remove(static_cast<std::size_t>(row));
    const QString text = tr("Delete “%1”").arg(frame.name);
    beginGroup(text);
    leaveFrame(frame.id, text);
    pushFrames(after, text);
    endGroup();
}

void ProjectDocument::leaveFrame(const QUuid& frame, const QString& text) {
    // Includes waypoints with a joint target, because their stored pose also depends on the frame.
    QVector<int> rows;
    std::vector<project::Waypoint> points;
    for (int i = 0; i < waypoints().size(); ++i) {
        const project::Waypoint& point = waypoints().at(i);
        if (point.frame == frame) {
            rows.append(i);
            points.push_back(project::givenIn(point, QUuid(), frames()).value_or(point));
        }
    }
    const Pose T_base_frame = frames().pose(frame).value_or(Pose());
    project::PatternList patternsAfter = patterns();
    for (std::size_t i = 0; i < patternsAfter.size(); ++i) {
        project::Pattern pattern = patternsAfter.at(i);
        if (pattern.first.frame != frame) {
            continue;
        }
        pattern.first = project::givenIn(pattern.first, QUuid(), frames()).value_or(pattern.first);
        pattern.columnEnd = T_base_frame * pattern.columnEnd;
        pattern.rowEnd = T_base_frame * pattern.rowEnd;
        patternsAfter.replace(i, pattern);
        // Use the exact result of the pattern. Otherwise, later changes of the pattern would treat these
        // waypoints as edited.
        for (std::size_t n = 0; n < points.size(); ++n) {
            if (project::isWhereLaid(waypoints().at(rows[static_cast<int>(n)]), patterns().at(i))) {
                points[n].pose = project::poseAt(pattern, points[n].place);
            }
        }
    }
    pushChanges(rows, std::move(points), text);
    pushPart(&project::Project::patterns, patternsAfter, text);

    project::CellGeometry cellAfter = cell();
    const auto leave = [&](auto& list) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            auto entity = list.at(i);
            if (entity.frame == frame) {
                entity.frame = QUuid();
                entity.pose = T_base_frame * entity.pose;
                list.replace(i, entity);
            }
        }
    };
    leave(cellAfter.boxes);
    leave(cellAfter.planes);
    pushPart(&project::Project::cell, cellAfter, text);

    project::Positions positionsAfter = positions();
    if (positionsAfter.safeHeight && positionsAfter.safeHeight->frame == frame) {
        const Eigen::Vector3d top = T_base_frame * Eigen::Vector3d(0, 0, positionsAfter.safeHeight->height);
        positionsAfter.safeHeight = project::SafeHeight{QUuid(), top.z()};
    }
    pushPart(&project::Project::positions, positionsAfter, text);
}

template <class Part>
void ProjectDocument::pushPart(Part project::Project::*part, const Part& after, const QString& text) {
    if (!(project_.*part == after)) {
        push(std::make_unique<EditPart<Part>>(part, project_.*part, after, text));
    }
}

void ProjectDocument::pushFrames(const project::FrameList& after, const QString& text) {
    pushPart(&project::Project::frames, after, text);
}

void ProjectDocument::changeTooling(const project::Tooling& after, const QString& text) {
    pushPart(&project::Project::tooling, after, text);
}

void ProjectDocument::changePositions(const project::Positions& after, const QString& text) {
    pushPart(&project::Project::positions, after, text);
}

void ProjectDocument::changeCell(const project::CellGeometry& after, const QString& text) {
    pushPart(&project::Project::cell, after, text);
}

void ProjectDocument::changePrograms(const project::ProgramList& after, const QString& text) {
    if (losesProgram(after)) {
        Q_EMIT removalRefused();
        return;
    }
    pushPart(&project::Project::programs, after, text);
}

bool ProjectDocument::losesProgram(const project::ProgramList& after) const {
    const QUuid guarded = programGuard_();
    return project_.programs.find(guarded) != nullptr && after.find(guarded) == nullptr;
}

void ProjectDocument::changePaths(const project::PathList& after, const QString& text) {
    pushPart(&project::Project::paths, after, text);
}

void ProjectDocument::changeModel(const project::ModelChange& change, const QString& text) {
    beginGroup(text);
    // Set the robot first, because waypoint positions depend on it.
    pushPart(&project::Project::robot, change.project.robot, text);
    QVector<int> rows;
    std::vector<project::Waypoint> changed;
    for (int row = 0; row < waypoints().size(); ++row) {
        const project::Waypoint& after = change.project.waypoints.at(row);
        if (!(waypoints().at(row) == after)) {
            rows.append(row);
            changed.push_back(after);
        }
    }
    pushChanges(rows, std::move(changed), text);
    pushPart(&project::Project::patterns, change.project.patterns, text);
    pushPart(&project::Project::positions, change.project.positions, text);
    pushPart(&project::Project::paths, change.project.paths, text);
    endGroup();
}

// ---- patterns --------------------------------------------------------------------------------------

QVector<int> ProjectDocument::rowsOf(const QUuid& pattern) const {
    QVector<int> rows;
    for (int row = 0; row < waypoints().size(); ++row) {
        if (waypoints().at(row).place.pattern == pattern) {
            rows.append(row);
        }
    }
    return rows;
}

void ProjectDocument::insertPattern(int row, const project::Pattern& pattern, const QString& text) {
    project::PatternList after = patterns();
    after.append(pattern);
    beginGroup(text);
    pushPart(&project::Project::patterns, after, text);
    insertWaypoints(row, project::waypointsOf(pattern, robot(), frames()), text);
    endGroup();
}

void ProjectDocument::changePattern(const project::Pattern& pattern, const QString& text) {
    const project::Pattern* before = patterns().find(pattern.id);
    if (before == nullptr || *before == pattern) {
        return;
    }
    beginGroup(text);
    replacePattern(pattern, text);
    endGroup();
}

void ProjectDocument::replacePattern(const project::Pattern& pattern, const QString& text) {
    const int index = patterns().indexOf(pattern.id);
    const project::Pattern before = patterns().at(static_cast<std::size_t>(index));
    project::PatternList after = patterns();
    after.replace(static_cast<std::size_t>(index), pattern);
    relay(before, pattern, text);
    pushPart(&project::Project::patterns, after, text);
}

void ProjectDocument::relay(const project::Pattern& before, const project::Pattern& after,
                            const QString& text) {
    const QVector<int> rows = rowsOf(after.id);
    const auto keyOf = [](const project::PatternPlace& place) {
        return std::tuple(place.layer, place.row, place.column);
    };
    std::map<std::tuple<int, int, int>, int> rowAt;
    for (const int row : rows) {
        rowAt[keyOf(waypoints().at(row).place)] = row;
    }
    // Build the new waypoint list of the pattern. Existing waypoints keep their IDs.
    QVector<int> changedRows;
    std::vector<project::Waypoint> changed;
    std::vector<project::Waypoint> added;
    QVector<QUuid> order;
    for (project::Waypoint& laid : project::waypointsOf(after, robot(), frames())) {
        const auto found = rowAt.find(keyOf(laid.place));
        if (found == rowAt.end()) {
            order.append(laid.id);
            added.push_back(std::move(laid));
            continue;
        }
        const project::Waypoint& now = waypoints().at(found->second);
        order.append(now.id);
        project::Waypoint then = now;
        if (now.name == project::nameAt(before, now.place)) {
            then.name = laid.name;
        }
        if (project::isWhereLaid(now, before)) {
            then.pose = laid.pose;
            then.frame = laid.frame;
            then.joints = laid.joints;
            then.tcpOffset = laid.tcpOffset;
        }
        // Update fields that still have the value of the pattern. Keep fields that were edited for a single
        // waypoint.
        const project::Waypoint& old = before.first;
        const auto follow = [&](auto project::Waypoint::*field) {
            if (now.*field == old.*field) {
                then.*field = laid.*field;
            }
        };
        follow(&project::Waypoint::move);
        follow(&project::Waypoint::jointSpeed);
        follow(&project::Waypoint::toolSpeed);
        follow(&project::Waypoint::blend);
        follow(&project::Waypoint::group);
        follow(&project::Waypoint::colour);
        follow(&project::Waypoint::note);
        follow(&project::Waypoint::actions);
        if (!(then == now)) {
            changedRows.append(found->second);
            changed.push_back(std::move(then));
        }
        rowAt.erase(found);
    }
    QVector<int> gone;
    for (const auto& [key, row] : rowAt) {
        gone.append(row);
    }
    std::sort(gone.begin(), gone.end());
    pushChanges(changedRows, std::move(changed), text);
    if (!gone.isEmpty()) {
        push(std::make_unique<RemoveWaypoints>(gone, text));
    }
    const int behind = rows.isEmpty() ? waypoints().size() : rows.last() + 1 - static_cast<int>(gone.size());
    if (!added.empty()) {
        insertWaypoints(behind, added, text);
    }
    // The rows of the pattern keep their positions in the list and are filled in pattern order.
    QVector<QUuid> ids;
    qsizetype next = 0;
    for (const project::Waypoint& point : waypoints()) {
        ids.append(point.place.pattern == after.id ? order[next++] : point.id);
    }
    pushOrder(ids, text);
}

void ProjectDocument::dissolvePattern(const QUuid& id, const QString& text) {
    const int index = patterns().indexOf(id);
    if (index < 0) {
        return;
    }
    const QVector<int> rows = rowsOf(id);
    std::vector<project::Waypoint> free;
    for (const int row : rows) {
        free.push_back(waypoints().at(row));
        free.back().place = {};
    }
    project::PatternList after = patterns();
    after.remove(static_cast<std::size_t>(index));
    beginGroup(text);
    pushChanges(rows, std::move(free), text);
    pushPart(&project::Project::patterns, after, text);
    endGroup();
}

void ProjectDocument::removePattern(const QUuid& id, const QString& text) {
    const int index = patterns().indexOf(id);
    if (index < 0) {
        return;
    }
    const QVector<int> rows = rowsOf(id);
    project::PatternList after = patterns();
    after.remove(static_cast<std::size_t>(index));
    beginGroup(text);
    if (!rows.isEmpty()) {
        push(std::make_unique<RemoveWaypoints>(rows, text));
    }
    pushPart(&project::Project::patterns, after, text);
    endGroup();
}

/// Updates the patterns whose corners are the changed waypoints.
void ProjectDocument::followCorners(const std::vector<project::Waypoint>& changed, const QString& text) {
    for (const project::Pattern& pattern : project::PatternList(patterns())) {
        project::Pattern after = pattern;
        for (const project::Waypoint& point : changed) {
            // Convert to the pattern's frame, because the corner waypoint may use another frame.
            const auto place = project::givenIn(point, pattern.first.frame, frames());
            if (!place) {
                continue;
            }
            if (point.id == pattern.corners[0]) {
                after.first.pose = place->pose;
                after.first.joints = place->joints;
                after.first.tcpOffset = place->tcpOffset;
            }
            if (point.id == pattern.corners[1]) {
                after.columnEnd = place->pose.position;
            }
            if (point.id == pattern.corners[2]) {
                after.rowEnd = place->pose.position;
            }
        }
        if (!(after == pattern)) {
            replacePattern(after, text);
        }
    }
}

/// Called before the waypoints at these rows are removed. Removes their positions from their patterns.
/// Patterns that use these waypoints as corners keep the corner pose but lose the link to the waypoint.
void ProjectDocument::forgetPlaces(const QList<int>& rows, const QString& text) {
    QSet<QUuid> going;
    for (const int row : rows) {
        going.insert(waypoints().at(row).id);
    }
    project::PatternList after = patterns();
    for (std::size_t i = 0; i < after.size(); ++i) {
        project::Pattern pattern = after.at(i);
        for (QUuid& corner : pattern.corners) {
            corner = going.contains(corner) ? QUuid() : corner;
        }
        std::set<std::pair<int, int>> left;
        for (const int row : rowsOf(pattern.id)) {
            const project::Waypoint& point = waypoints().at(row);
            if (!going.contains(point.id)) {
                left.insert({point.place.row, point.place.column});
            }
        }
        for (const int row : rows) {
            const project::PatternPlace& place = waypoints().at(row).place;
            if (place.pattern == pattern.id && left.insert({place.row, place.column}).second) {
                pattern.excluded.push_back({place.column, place.row});
            }
        }
        after.replace(i, pattern);
    }
    pushPart(&project::Project::patterns, after, text);
}

// ---- for the undo commands -------------------------------------------------------------------------

void ProjectDocument::insertRaw(int row, const std::vector<project::Waypoint>& waypoints) {
    const int last = row + static_cast<int>(waypoints.size()) - 1;
    Q_EMIT waypointsAboutToBeInserted(row, last);
    std::vector<project::Reach> reaches;
    int at = row;
    for (const project::Waypoint& waypoint : waypoints) {
        project_.waypoints.insert(at++, waypoint);
        reaches.push_back(reachOf(waypoint));
    }
    reach_.insert(reach_.begin() + row, reaches.begin(), reaches.end());
    Q_EMIT waypointsInserted(row, last);
    Q_EMIT documentChanged();
}

std::vector<project::Waypoint> ProjectDocument::takeRaw(const QVector<int>& rows) {
    std::vector<project::Waypoint> taken;
    // Remove adjacent rows as one range, starting with the last range.
    for (auto to = static_cast<int>(rows.size()); to > 0;) {
        int from = to - 1;
        while (from > 0 && rows[from - 1] == rows[from] - 1) {
            --from;
        }
        Q_EMIT waypointsAboutToBeRemoved(rows[from], rows[to - 1]);
        for (int i = to - 1; i >= from; --i) {
            taken.push_back(project_.waypoints.take(rows[i]));
            reach_.erase(reach_.begin() + rows[i]);
        }
        Q_EMIT waypointsRemoved();
        to = from;
    }
    std::reverse(taken.begin(), taken.end());
    Q_EMIT documentChanged();
    return taken;
}

void ProjectDocument::replaceRaw(const std::vector<project::Waypoint>& waypoints) {
    int first = std::numeric_limits<int>::max();
    int last = -1;
    for (const project::Waypoint& waypoint : waypoints) {
        const int row = project_.waypoints.indexOf(waypoint.id);
        project_.waypoints.replace(row, waypoint);
        reach_.at(static_cast<std::size_t>(row)) = reachOf(waypoint);
        first = std::min(first, row);
        last = std::max(last, row);
    }
    Q_EMIT waypointsChanged(first, last);
    Q_EMIT documentChanged();
}

void ProjectDocument::reorderRaw(const QVector<QUuid>& order) {
    Q_EMIT orderAboutToChange();
    QHash<QUuid, int> rows;
    for (int row = 0; row < waypoints().size(); ++row) {
        rows.insert(waypoints().at(row).id, row);
    }
    project::WaypointList sorted;
    for (const QUuid& id : order) {
        sorted.append(waypoints().at(rows.value(id)));
    }
    project_.waypoints = sorted;
    refreshReach();
    Q_EMIT orderChanged();
    Q_EMIT documentChanged();
}

void ProjectDocument::notifyPart(const project::FrameList&) {
    refreshReach();
    notifyAllChanged();
    Q_EMIT framesChanged();
    Q_EMIT documentChanged();
}

void ProjectDocument::notifyPart(const project::Tooling&) {
    Q_EMIT toolingChanged();
    Q_EMIT documentChanged();
}

void ProjectDocument::notifyPart(const project::Positions&) {
    Q_EMIT positionsChanged();
    Q_EMIT documentChanged();
}

void ProjectDocument::notifyPart(const project::PatternList&) {
    Q_EMIT patternsChanged();
    Q_EMIT documentChanged();
}

void ProjectDocument::notifyPart(const project::CellGeometry&) {
    Q_EMIT cellChanged();
    Q_EMIT documentChanged();
}

void ProjectDocument::notifyPart(const project::PathList&) {
    Q_EMIT pathsChanged();
    Q_EMIT documentChanged();
}

void ProjectDocument::notifyPart(const project::ProgramList&) {
    Q_EMIT documentChanged();
}

void ProjectDocument::notifyPart(const std::optional<RobotModelId>&) {
    if (!isConnected_) {
        clearRobot();
    }
    refreshReach();
    notifyAllChanged();
    Q_EMIT documentChanged();
}

}  // namespace tiller

#include "moc_project_document.cpp"
