// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/waypoint_dialogs.h"

#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>

#include "robot/core/atomic_file.h"
#include "robot/core/file_reading.h"
#include "robot/station/document/project_document.h"
#include "robot/station/document/waypoint_exchange.h"
#include "widgets/waypoints/actions_dialog.h"
#include "widgets/waypoints/pattern_dialog.h"
#include "widgets/waypoints/waypoint_history_dialog.h"
#include "widgets/waypoints/waypoint_properties.h"
#include "widgets/waypoints/waypoint_shift.h"
#include "widgets/waypoints/waypoint_table.h"

namespace tiller {
namespace {

/// A larger file cannot be a list of waypoints.
constexpr qint64 kMaxImportBytes = 64LL * 1024 * 1024;

bool isJson(const QString& path) {
    return path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive) ||
           path.endsWith(QLatin1String(".tiller"), Qt::CaseInsensitive);
}

}  // namespace

WaypointDialogs::WaypointDialogs(ProjectDocument& document, WaypointTable& table, QObject* parent)
    : QObject(parent), document_(document), table_(table) {}

void WaypointDialogs::setLive(const JointPositions& q, const Pose& tcpOffset) {
    liveJoints_ = q;
    liveTcp_ = tcpOffset;
}

std::vector<project::Waypoint> WaypointDialogs::selected() const {
    std::vector<project::Waypoint> result;
    for (const int row : table_.selectedRows()) {
        result.push_back(document_.waypoints().at(row));
    }
    return result;
}

QUuid WaypointDialogs::patternOfCurrent() const {
    const QModelIndex current = table_.currentIndex();
    return current.isValid() ? document_.waypoints().at(current.row()).place.pattern : QUuid();
}

void WaypointDialogs::properties() {
    const QList<int> rows = table_.selectedRows();
    if (rows.isEmpty()) {
        Q_EMIT refused(tr("Select waypoints to change."), {});
        return;
    }
    QStringList groups;
    for (const project::Waypoint& point : document_.waypoints()) {
        if (!point.group.isEmpty() && !groups.contains(point.group)) {
            groups << point.group;
        }
    }
    groups.sort();
    const auto& fastest = document_.robot().maxJointSpeed;
    WaypointProperties dialog(selected(), groups, *std::min_element(fastest.begin(), fastest.end()),
                              table_.window());
    if (dialog.exec() == QDialog::Accepted) {
        document_.changeWaypoints(
            rows, dialog.changed(),
            tr("Change the properties of %n waypoints", nullptr, static_cast<int>(rows.size())));
    }
}

void WaypointDialogs::actions() {
    const QList<int> rows = table_.selectedRows();
    if (rows.isEmpty()) {
        Q_EMIT refused(tr("Select the waypoints to add actions to."), {});
        return;
    }
    std::vector<project::Waypoint> points = selected();
    ActionsDialog dialog(points, table_.window());
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    for (project::Waypoint& point : points) {
        point.actions = dialog.actions();
    }
    document_.changeWaypoints(
        rows, points, tr("Change the actions at %n waypoints", nullptr, static_cast<int>(rows.size())));
}

void WaypointDialogs::moveSelection() {
    const QList<int> rows = table_.selectedRows();
    if (rows.isEmpty()) {
        Q_EMIT refused(tr("Select waypoints to move."), {});
        return;
    }
    WaypointShift dialog(document_, selected(), table_.window());
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    if (const auto moved = dialog.moved()) {
        document_.changeWaypoints(
            rows, *moved,
            tr("Offset, rotate or mirror %n waypoints", nullptr, static_cast<int>(rows.size())));
    }
}

void WaypointDialogs::pattern() {
    if (const project::Pattern* there = document_.patterns().find(patternOfCurrent())) {
        PatternDialog dialog(document_, *there, table_.window());
        if (dialog.exec() == QDialog::Accepted) {
            document_.changePattern(dialog.pattern(),
                                    tr("Change the pattern “%1”").arg(dialog.pattern().name));
        }
        return;
    }
    QVector<QUuid> corners;
    for (const project::Waypoint& point : selected()) {
        corners.append(point.id);
    }
    if (document_.waypoints().isEmpty()) {
        Q_EMIT refused(tr("Teach three waypoints at the corners of the pattern first."), {});
        return;
    }
    PatternDialog dialog(document_, corners, table_.window());
    if (dialog.exec() == QDialog::Accepted) {
        const QList<int> rows = table_.selectedRows();
        document_.insertPattern(rows.isEmpty() ? document_.waypoints().size() : rows.last() + 1,
                                dialog.pattern(), tr("Create the pattern “%1”").arg(dialog.pattern().name));
    }
}

void WaypointDialogs::dissolvePattern() {
    if (const project::Pattern* there = document_.patterns().find(patternOfCurrent())) {
        document_.dissolvePattern(there->id, tr("Convert the pattern “%1” to waypoints").arg(there->name));
    } else {
        Q_EMIT refused(tr("Select a waypoint that belongs to a pattern."), {});
    }
}

void WaypointDialogs::removePattern() {
    if (const project::Pattern* there = document_.patterns().find(patternOfCurrent())) {
        document_.removePattern(there->id, tr("Delete the pattern “%1”").arg(there->name));
    } else {
        Q_EMIT refused(tr("Select a waypoint that belongs to a pattern."), {});
    }
}

void WaypointDialogs::history() {
    const QModelIndex current = table_.currentIndex();
    if (!current.isValid()) {
        Q_EMIT refused(tr("Select a waypoint to see its history."), {});
        return;
    }
    const project::Waypoint point = document_.waypoints().at(current.row());
    WaypointHistoryDialog dialog(document_, point, table_.window());
    if (dialog.exec() == QDialog::Accepted && !point.history.isEmpty()) {
        const project::Waypoint earlier = dialog.chosen();
        if (!document_.frames().pose(earlier.frame)) {
            Q_EMIT refused(tr("The earlier version cannot be restored because its frame was deleted from the "
                              "project. Select a different version."),
                           {});
            return;
        }
        document_.changeWaypoint(document_.waypoints().indexOf(point.id), earlier,
                                 tr("Restore an earlier version of “%1”").arg(point.name));
    }
}

void WaypointDialogs::importFile() {
    const QString path =
        QFileDialog::getOpenFileName(table_.window(), tr("Import waypoints"), {},
                                     tr("Waypoint files (*.csv *.txt *.json *.tiller);;All files (*)"));
    if (!path.isEmpty()) {
        importFrom(path);
    }
}

void WaypointDialogs::exportFile() {
    const QString path =
        QFileDialog::getSaveFileName(table_.window(), tr("Export waypoints"), QStringLiteral("waypoints.csv"),
                                     tr("CSV file (*.csv);;JSON file (*.json)"));
    if (!path.isEmpty()) {
        exportTo(path);
    }
}

void WaypointDialogs::importFrom(const QString& path) {
    const QString name = QFileInfo(path).fileName();
    const Result<QByteArray> read = readWholeFile(path, kMaxImportBytes);
    if (!read) {
        Q_EMIT refused(tr("Import failed"),
                       read.error().code == ErrorCode::FileCorrupt
                           ? tr("%1 is too large. The maximum size of a waypoint file is 64 MB.").arg(name)
                           : tr("%1: %2").arg(name, read.error().controllerMessage));
        return;
    }
    const QByteArray& bytes = *read;
    waypoint_exchange::Imported imported;
    Error error;
    if (isJson(path)) {
        const auto found = waypoint_exchange::fromJson(bytes, document_.frames());
        error = found.error();
        if (found) {
            imported = *found;
        }
    } else {
        waypoint_clipboard::Defaults defaults;
        defaults.robot = &document_.robot();
        defaults.near = liveJoints_;
        defaults.tcpOffset = liveTcp_;
        const auto found = waypoint_exchange::fromCsv(bytes, document_.frames(), defaults);
        error = found.error();
        if (found) {
            imported.waypoints = *found;
        }
    }
    if (error.code != ErrorCode::None || imported.waypoints.empty()) {
        Q_EMIT refused(tr("Import failed"),
                       error.code == ErrorCode::None
                           ? tr("%1 contains no waypoints. Choose a different file.").arg(name)
                           : tr("%1: %2").arg(name, error.context));
        return;
    }
    project::WaypointList names = document_.waypoints();
    for (project::Waypoint& point : imported.waypoints) {
        point.name = point.name.isEmpty() ? names.nextName(tr("waypoint")) : names.uniqueName(point.name);
        names.append(point);
    }
    const QModelIndex current = table_.currentIndex();
    const int row = current.isValid() ? current.row() + 1 : document_.waypoints().size();
    const QString text = tr("Import %n waypoints", nullptr, static_cast<int>(imported.waypoints.size()));
    document_.beginGroup(text);
    for (const project::Frame& frame : imported.frames) {
        document_.insertFrame(static_cast<int>(document_.frames().size()), frame, text);
    }
    document_.insertWaypoints(row, imported.waypoints, text);
    document_.endGroup();
}

void WaypointDialogs::exportTo(const QString& path) {
    std::vector<project::Waypoint> chosen = selected();
    if (chosen.size() < 2) {
        chosen.assign(document_.waypoints().begin(), document_.waypoints().end());
    }
    if (chosen.empty()) {
        Q_EMIT refused(tr("The project contains no waypoints to export. Teach a waypoint first."), {});
        return;
    }
    const QString full = QFileInfo(path).suffix().isEmpty() ? path + QStringLiteral(".csv") : path;
    const Result<QByteArray> bytes =
        isJson(full) ? waypoint_exchange::toJson(chosen, document_.frames(), document_.robot().id)
                     : Result<QByteArray>(waypoint_exchange::toCsv(chosen, document_.frames()));
    const Result<void> written = bytes ? writeFileAtomically(full, *bytes) : Result<void>(bytes.error());
    if (!written) {
        const Error& error = written.error();
        Q_EMIT refused(
            tr("Export failed"),
            tr("%1: %2").arg(QFileInfo(full).fileName(), bytes ? error.controllerMessage : error.context));
        return;
    }
    Q_EMIT done(tr("%n waypoints exported to %1", nullptr, static_cast<int>(chosen.size()))
                    .arg(QFileInfo(full).fileName()));
}

}  // namespace tiller

#include "moc_waypoint_dialogs.cpp"
