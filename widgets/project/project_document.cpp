// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/project/project_document.h"

#include <algorithm>

#include "widgets/project/project_commands.h"

namespace tiller {

ProjectDocument::ProjectDocument(QObject* parent)
    : QObject(parent), robot_(&robotModel(RobotModelId::UR5e)) {}

void ProjectDocument::setRobot(RobotModelId robot) {
    if (robot_->id == robot) {
        return;
    }
    robot_ = &robotModel(robot);
    refreshReach();
    tellAllChanged();
}

void ProjectDocument::setProject(project::Project project) {
    Q_EMIT projectAboutToBeReplaced();
    project_ = std::move(project);
    refreshReach();
    Q_EMIT projectReplaced();
    undo_.clear();
    Q_EMIT framesChanged();
    Q_EMIT documentChanged();
}

void ProjectDocument::refreshReach() {
    reach_.clear();
    for (const project::Waypoint& point : waypoints()) {
        reach_.push_back(project::reach(*robot_, point, frames()));
    }
}

void ProjectDocument::tellAllChanged() {
    if (!waypoints().isEmpty()) {
        Q_EMIT waypointsChanged(0, waypoints().size() - 1);
    }
}

// ---- edits by hand ---------------------------------------------------------------------------------

void ProjectDocument::insertWaypoints(int row, const std::vector<project::Waypoint>& waypoints,
                                      const QString& text) {
    if (!waypoints.empty()) {
        undo_.push(
            new InsertWaypoints(*this, std::clamp(row, 0, project_.waypoints.size()), waypoints, text));
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
    undo_.push(new RemoveWaypoints(*this, rows, text));
}

void ProjectDocument::changeWaypoint(int row, const project::Waypoint& waypoint, const QString& text) {
    if (!(waypoints().at(row) == waypoint)) {
        undo_.push(new ChangeWaypoint(*this, row, waypoint, text));
    }
}

void ProjectDocument::moveWaypointsBefore(const QList<int>& rows, int before) {
    QVector<QUuid> front;
    QVector<QUuid> moved;
    QVector<QUuid> back;
    QVector<QUuid> old;
    for (int row = 0; row < waypoints().size(); ++row) {
        const QUuid id = waypoints().at(row).id;
        old.append(id);
        (rows.contains(row) ? moved : row < before ? front : back).append(id);
    }
    const QVector<QUuid> order = front + moved + back;
    if (order != old) {
        undo_.push(new ReorderWaypoints(*this, order, tr("Change the order")));
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
    undo_.beginMacro(text);
    // Also those whose joints rule: the pose they remember must not lose its frame.
    for (int i = 0; i < waypoints().size(); ++i) {
        const project::Waypoint point = waypoints().at(i);
        if (point.frame == frame.id) {
            changeWaypoint(i, project::givenIn(point, QUuid(), frames()).value_or(point), text);
        }
    }
    pushFrames(after, text);
    undo_.endMacro();
}

void ProjectDocument::pushFrames(const project::FrameList& after, const QString& text) {
    undo_.push(new EditFrames(*this, after, text));
}

// ---- for the undo commands -------------------------------------------------------------------------

void ProjectDocument::insertRaw(int row, const project::Waypoint& waypoint) {
    Q_EMIT waypointAboutToBeInserted(row);
    project_.waypoints.insert(row, waypoint);
    reach_.insert(reach_.begin() + row, project::reach(*robot_, waypoint, frames()));
    Q_EMIT waypointInserted(row);
    Q_EMIT documentChanged();
}

project::Waypoint ProjectDocument::takeRaw(int row) {
    Q_EMIT waypointAboutToBeRemoved(row);
    project::Waypoint taken = project_.waypoints.take(row);
    reach_.erase(reach_.begin() + row);
    Q_EMIT waypointRemoved(row);
    Q_EMIT documentChanged();
    return taken;
}

void ProjectDocument::replaceRaw(int row, const project::Waypoint& waypoint) {
    project_.waypoints.replace(row, waypoint);
    reach_.at(static_cast<std::size_t>(row)) = project::reach(*robot_, waypoint, frames());
    Q_EMIT waypointsChanged(row, row);
    Q_EMIT documentChanged();
}

void ProjectDocument::reorderRaw(const QVector<QUuid>& order) {
    Q_EMIT orderAboutToChange();
    project::WaypointList sorted;
    for (const QUuid& id : order) {
        sorted.append(waypoints().at(waypoints().indexOf(id)));
    }
    project_.waypoints = sorted;
    refreshReach();
    Q_EMIT orderChanged();
    Q_EMIT documentChanged();
}

void ProjectDocument::setFramesRaw(const project::FrameList& frames) {
    project_.frames = frames;
    refreshReach();
    tellAllChanged();
    Q_EMIT framesChanged();
    Q_EMIT documentChanged();
}

}  // namespace tiller

#include "moc_project_document.cpp"
