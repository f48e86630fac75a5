// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an operator types into the table, and what is dragged in it.

#include <QDataStream>
#include <QIODevice>
#include <QMimeData>
#include <algorithm>
#include <cmath>

#include "robot/core/angles.h"
#include "robot/kinematics/arm_kinematics.h"
#include "widgets/common/format.h"
#include "widgets/common/notation.h"
#include "widgets/waypoints/waypoint_model.h"

namespace tiller {
namespace {

constexpr char kRowsMime[] = "application/x-tiller-waypoint-rows";
constexpr double kLeastToolSpeed = 0.001;  ///< [m/s]
constexpr double kMostToolSpeed = 1.0;     ///< [m/s]
constexpr double kMostBlend = 1.0;         ///< [m]

/// "250", "250,5", "250 mm/s" -> 250; nothing when there is no number in front.
std::optional<double> leadingNumber(const QString& text) {
    QString figure;
    for (const QChar c : text.trimmed()) {
        if (!c.isDigit() && c != u'.' && c != u',' && c != u'-') {
            break;
        }
        figure += c == u',' ? QChar(u'.') : c;
    }
    bool ok = false;
    const double value = figure.toDouble(&ok);
    return ok && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

bool WaypointModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !index.isValid() || index.row() >= rowCount()) {
        return false;
    }
    const QString text = value.toString().trimmed();
    switch (index.column()) {
        case Name:
            return setName(index.row(), text);
        case Move:
            return setMove(index.row(), text);
        case Frame:
            return setFrame(index.row(), text);
        case Speed:
        case Blend:
            return setFigure(index.row(), index.column(), text);
        default:
            return false;
    }
}

bool WaypointModel::setName(int row, const QString& text) {
    project::Waypoint point = waypointAt(row);
    if (text == point.name) {
        return true;
    }
    if (text.isEmpty()) {
        Q_EMIT editRefused(tr("A waypoint needs a name."));
        return false;
    }
    if (document_.waypoints().indexOfName(text) >= 0) {
        Q_EMIT editRefused(tr("“%1” is taken by waypoint %2. Choose another name.")
                               .arg(text)
                               .arg(document_.waypoints().indexOfName(text) + 1));
        return false;
    }
    const QString before = point.name;
    point.name = text;
    document_.changeWaypoint(row, point, tr("Rename “%1” to “%2”").arg(before, text));
    return true;
}

bool WaypointModel::setMove(int row, const QString& text) {
    project::Waypoint point = waypointAt(row);
    if (text != QLatin1String("J") && text != QLatin1String("L")) {
        return false;
    }
    point.move = text == QLatin1String("J") ? project::MoveKind::Joint : project::MoveKind::Linear;
    document_.changeWaypoint(
        row, point,
        (point.move == project::MoveKind::Joint ? tr("Make “%1” a MoveJ") : tr("Make “%1” a MoveL"))
            .arg(point.name));
    return true;
}

QStringList WaypointModel::frameChoices() const {
    QStringList result = {QStringLiteral("—"), tr("Base")};
    for (const project::Frame& frame : document_.frames()) {
        result << frame.name;
    }
    return result;
}

bool WaypointModel::setFrame(int row, const QString& text) {
    project::Waypoint point = waypointAt(row);
    if (text == display(point, row, Frame)) {
        return true;
    }
    if (text == QStringLiteral("—")) {
        // The joints take over where the pose would have brought the arm.
        if (document_.reach(row).ok()) {
            point.joints = document_.reach(row).q;
        }
        point.ruling = project::Ruling::Joints;
        document_.changeWaypoint(row, point, tr("Use joint positions for “%1”").arg(point.name));
        return true;
    }
    const project::Frame* frame = document_.frames().findByName(text);
    if (frame == nullptr && text != tr("Base")) {
        Q_EMIT editRefused(tr("There is no frame “%1” in this project.").arg(text));
        return false;
    }
    // The place stays where it is: only the axes it is given in change.
    const std::optional<Pose> place =
        point.ruling == project::Ruling::Joints
            ? std::optional(kinematics::forwardTcp(document_.robot().dh, point.joints, point.tcpOffset))
            : project::poseInBase(point, document_.frames());
    point.ruling = project::Ruling::Pose;
    point.frame = frame == nullptr ? QUuid() : frame->id;
    if (place) {
        point = *project::taughtAt(point, point.joints, *place, point.tcpOffset, document_.frames());
    }
    document_.changeWaypoint(row, point, tr("Give “%1” in %2").arg(point.name, text));
    return true;
}

bool WaypointModel::setFigure(int row, int column, const QString& text) {
    project::Waypoint point = waypointAt(row);
    if (text == data(index(row, column), Qt::EditRole).toString()) {
        return true;  // the digits that are not shown stay
    }
    const std::optional<double> figure = leadingNumber(text);
    if (!figure) {
        Q_EMIT editRefused(tr("“%1” is not a number.").arg(text));
        return false;
    }
    const bool turns = column == Speed && point.move == project::MoveKind::Joint;
    const double unit = turns ? toRadians(1) : format::metresPerUnit();
    const double value = *figure * unit;
    const double least = column == Blend ? 0 : turns ? toRadians(1) : kLeastToolSpeed;
    const double most = column == Blend ? kMostBlend
                        : turns         ? *std::min_element(document_.robot().maxJointSpeed.begin(),
                                                            document_.robot().maxJointSpeed.end())
                                        : kMostToolSpeed;
    if (value < least * (1 - 1e-9) || value > most * (1 + 1e-9)) {
        const auto shown = [&](double bound) {
            return turns             ? format::degreesPerSecond(bound)
                   : column == Blend ? format::shortLength(bound)
                                     : format::speed(bound);
        };
        Q_EMIT editRefused(tr("%1 is outside %2 to %3.").arg(shown(value), shown(least), shown(most)));
        return false;
    }
    if (column == Blend) {
        point.blend = value;
        document_.changeWaypoint(row, point, tr("Set the blend of “%1”").arg(point.name));
    } else {
        (turns ? point.jointSpeed : point.toolSpeed) = value;
        document_.changeWaypoint(row, point, tr("Set the speed of “%1”").arg(point.name));
    }
    return true;
}

// ---- drag and drop ---------------------------------------------------------------------------------

QStringList WaypointModel::mimeTypes() const {
    return {QLatin1String(kRowsMime)};
}

QMimeData* WaypointModel::mimeData(const QModelIndexList& indexes) const {
    QList<int> rows;
    for (const QModelIndex& index : indexes) {
        if (!rows.contains(index.row())) {
            rows.append(index.row());
        }
    }
    std::sort(rows.begin(), rows.end());
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream << rows;
    auto* mime = new QMimeData;
    mime->setData(QLatin1String(kRowsMime), bytes);
    return mime;
}

bool WaypointModel::canDropMimeData(const QMimeData* data, Qt::DropAction action, int, int,
                                    const QModelIndex&) const {
    return action == Qt::MoveAction && data != nullptr && data->hasFormat(QLatin1String(kRowsMime));
}

bool WaypointModel::dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                                 const QModelIndex& parent) {
    if (!canDropMimeData(data, action, row, column, parent)) {
        return false;
    }
    QByteArray bytes = data->data(QLatin1String(kRowsMime));
    QDataStream stream(&bytes, QIODevice::ReadOnly);
    QList<int> rows;
    stream >> rows;
    const int before = row >= 0 ? row : parent.isValid() ? parent.row() : rowCount();
    document_.moveWaypointsBefore(rows, before);
    return true;
}

}  // namespace tiller
