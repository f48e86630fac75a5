// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/waypoint_editing.h"

#include <QApplication>
#include <QClipboard>
#include <algorithm>

#include "robot/station/document/project_document.h"
#include "robot/station/document/waypoint_clipboard.h"
#include "widgets/waypoints/waypoint_table.h"

namespace tiller {

WaypointEditing::WaypointEditing(ProjectDocument& document, WaypointTable& table, QObject* parent)
    : QObject(parent), document_(document), table_(table) {}

int WaypointEditing::rowCount() const {
    return document_.waypoints().size();
}

void WaypointEditing::duplicate() {
    const QList<int> rows = table_.selectedRows();
    if (rows.isEmpty()) {
        return;
    }
    project::WaypointList names = document_.waypoints();
    std::vector<project::Waypoint> copies;
    for (const int row : rows) {
        project::Waypoint copy = document_.waypoints().at(row);
        copy.id = QUuid::createUuid();
        copy.name = names.uniqueName(copy.name);
        copy.place = {};
        copy.history = {};
        names.append(copy);
        copies.push_back(std::move(copy));
    }
    const QString text = copies.size() == 1
                             ? tr("Duplicate “%1”").arg(document_.waypoints().at(rows[0]).name)
                             : tr("Duplicate %n waypoints", nullptr, static_cast<int>(copies.size()));
    document_.insertWaypoints(rows.last() + 1, copies, text);
}

void WaypointEditing::remove() {
    const QList<int> rows = table_.selectedRows();
    if (rows.isEmpty()) {
        return;
    }
    document_.removeWaypoints(rows);
    Q_EMIT rowWanted(std::min(rows.first(), rowCount() - 1));
}

void WaypointEditing::move(int by) {
    const QList<int> rows = table_.selectedRows();
    if (rows.isEmpty() || (by < 0 && rows.first() == 0) || (by > 0 && rows.last() == rowCount() - 1)) {
        return;
    }
    document_.moveWaypointsBefore(rows, by < 0 ? rows.first() - 1 : rows.last() + 2);
}

void WaypointEditing::copy() const {
    std::vector<project::Waypoint> chosen;
    for (const int row : table_.selectedRows()) {
        chosen.push_back(document_.waypoints().at(row));
    }
    if (!chosen.empty()) {
        QApplication::clipboard()->setText(waypoint_clipboard::toText(chosen, document_.frames()));
    }
}

void WaypointEditing::setLive(const JointPositions& q, const Pose& tcpOffset) {
    liveJoints_ = q;
    liveTcp_ = tcpOffset;
}

void WaypointEditing::paste() {
    waypoint_clipboard::Defaults defaults;
    defaults.robot = &document_.robot();
    defaults.near = liveJoints_;
    defaults.tcpOffset = liveTcp_;
    if (const QModelIndex beside = table_.currentIndex(); beside.isValid()) {
        defaults.near = document_.waypoints().at(beside.row()).joints;
        defaults.tcpOffset = document_.waypoints().at(beside.row()).tcpOffset;
    }
    Result<std::vector<project::Waypoint>> pasted =
        waypoint_clipboard::fromText(QApplication::clipboard()->text(), document_.frames(), defaults);
    if (!pasted) {
        Q_EMIT refused(tr("Paste failed"), pasted.error().context);
        return;
    }
    if (pasted->empty()) {
        Q_EMIT refused(tr("The clipboard contains no waypoints. Copy waypoints first."), {});
        return;
    }
    project::WaypointList names = document_.waypoints();
    for (project::Waypoint& point : *pasted) {
        point.name = point.name.isEmpty() ? names.nextName(tr("waypoint")) : names.uniqueName(point.name);
        names.append(point);
    }
    const QModelIndex current = table_.currentIndex();
    document_.insertWaypoints(current.isValid() ? current.row() + 1 : rowCount(), *pasted,
                              tr("Paste %n waypoints", nullptr, static_cast<int>(pasted->size())));
}

}  // namespace tiller

#include "moc_waypoint_editing.cpp"
