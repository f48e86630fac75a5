// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/waypoint_model.h"

#include <QColor>
#include <QDataStream>
#include <QIODevice>
#include <QMimeData>
#include <algorithm>
#include <cmath>
#include <utility>

#include "robot/core/angles.h"
#include "robot/kinematics/arm_kinematics.h"
#include "robot/station/route/action_words.h"
#include "robot/station/text/format.h"
#include "robot/station/text/notation.h"
#include "robot/station/text/reach_words.h"
#include "widgets/common/theme.h"
#include "widgets/waypoints/waypoint_properties.h"

namespace tiller {
namespace {

constexpr char kRowsMime[] = "application/x-tiller-waypoint-rows";
constexpr double kMinTcpSpeed = 0.001;   ///< [m/s]
constexpr double kMaxTcpSpeed = 1.0;     ///< [m/s]
constexpr double kMaxBlendRadius = 1.0;  ///< [m]

/// The curve colours of the light theme, after black for the default. They are distinguishable for people
/// with colour vision deficiencies.
QColor colourOf(project::WaypointColour colour) {
    static constexpr QRgb kColours[] = {0x000000, 0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7, 0xE69F00, 0x56B4E9};
    return QColor(kColours[static_cast<int>(colour)]);
}

/// Returns the name, marked if it is the next waypoint, and the number of actions.
QString shownName(const project::Waypoint& point, bool coming) {
    QString text = coming ? QStringLiteral("▶ ") + point.name : point.name;
    if (!point.actions.empty()) {
        text += QStringLiteral("  ⚙%1").arg(point.actions.size());
    }
    return text;
}

/// Returns the leading number of a text, e.g. 250 for "250" or "250 mm/s". A decimal comma is accepted. Empty
/// if the text does not start with a number.
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

WaypointModel::WaypointModel(ProjectDocument& document, QObject* parent)
    : QAbstractTableModel(parent), document_(document) {
    followDocument();
}

void WaypointModel::followDocument() {
    const ProjectDocument* document = &document_;
    connect(document, &ProjectDocument::projectAboutToBeReplaced, this, [this] { beginResetModel(); });
    connect(document, &ProjectDocument::projectReplaced, this, [this] { endResetModel(); });
    connect(document, &ProjectDocument::waypointsAboutToBeInserted, this,
            [this](int first, int last) { beginInsertRows({}, first, last); });
    connect(document, &ProjectDocument::waypointsInserted, this, [this] { endInsertRows(); });
    connect(document, &ProjectDocument::waypointsAboutToBeRemoved, this,
            [this](int first, int last) { beginRemoveRows({}, first, last); });
    connect(document, &ProjectDocument::waypointsRemoved, this, [this] { endRemoveRows(); });
    connect(document, &ProjectDocument::waypointsChanged, this, [this](int first, int last) {
        Q_EMIT dataChanged(index(first, 0), index(last, ColumnCount - 1));
    });
    connect(document, &ProjectDocument::orderAboutToChange, this, [this] {
        Q_EMIT layoutAboutToBeChanged({}, VerticalSortHint);
        orderBefore_.clear();
        for (const QModelIndex& old : persistentIndexList()) {
            orderBefore_.append(waypointAt(old.row()).id);
        }
    });
    connect(document, &ProjectDocument::orderChanged, this, [this] {
        const QModelIndexList before = persistentIndexList();
        QModelIndexList after;
        QHash<QUuid, int> rows;
        for (int row = 0; row < rowCount(); ++row) {
            rows.insert(waypointAt(row).id, row);
        }
        for (qsizetype i = 0; i < before.size(); ++i) {
            after.append(index(rows.value(orderBefore_[i]), before[i].column()));
        }
        changePersistentIndexList(before, after);
        Q_EMIT layoutChanged({}, VerticalSortHint);
    });
}

void WaypointModel::setComing(const QUuid& id) {
    const QUuid before = std::exchange(coming_, id);
    if (before == id) {
        return;
    }
    for (const QUuid& changed : {before, id}) {
        if (const int row = document_.waypoints().indexOf(changed); row >= 0) {
            Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
        }
    }
}

void WaypointModel::setPathLimit(const QUuid& id, const QString& limit) {
    if (pathLimits_.value(id) == limit) {
        return;
    }
    if (limit.isEmpty()) {
        pathLimits_.remove(id);
    } else {
        pathLimits_.insert(id, limit);
    }
    if (const int row = document_.waypoints().indexOf(id); row >= 0) {
        Q_EMIT dataChanged(index(row, ReachColumn), index(row, ReachColumn));
    }
}

// ---- data and flags for the view -------------------------------------------------------------------

int WaypointModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : document_.waypoints().size();
}

int WaypointModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString WaypointModel::display(const project::Waypoint& point, int row, int column) const {
    switch (column) {
        case Number:
            return QString::number(row + 1);
        case Name:
            return shownName(point, point.id == coming_);
        case Move:
            return point.move == project::MoveKind::Joint ? QStringLiteral("J") : QStringLiteral("L");
        case Frame: {
            if (point.priority == project::TargetKind::Joints) {
                return QStringLiteral("—");
            }
            const project::Frame* frame = document_.frames().find(point.frame);
            return point.frame.isNull() ? tr("Base") : frame != nullptr ? frame->name : tr("missing");
        }
        case Speed:
            return point.move == project::MoveKind::Joint ? format::degreesPerSecond(point.jointSpeed)
                                                          : format::speed(point.toolSpeed);
        case Blend:
            return QString::number(point.blend / format::metresPerUnit(), 'g', 6);
        case ReachColumn:
            return document_.reach(row).ok() && !pathLimit(row).isEmpty() ? tr("✕ path")
                                                                          : reachText(document_.reach(row));
        default:
            return {};
    }
}

QString WaypointModel::toolTip(const project::Waypoint& point, int row, int column) const {
    switch (column) {
        case Name: {
            QStringList lines{point.name};
            if (!point.group.isEmpty()) {
                lines << tr("Group: %1").arg(point.group);
            }
            if (point.colour != project::WaypointColour::None) {
                lines << tr("Colour: %1")
                             .arg(WaypointProperties::colourNames().value(static_cast<int>(point.colour)));
            }
            if (!point.actions.empty()) {
                lines << tr("Actions: %1").arg(ActionWords::of(point.actions).join(QStringLiteral(" · ")));
            }
            if (!point.note.isEmpty()) {
                lines << point.note;
            }
            return lines.join(QLatin1Char('\n'));
        }
        case Move:
            return point.move == project::MoveKind::Joint ? tr("MoveJ: all joints start and stop together")
                                                          : tr("MoveL: the TCP moves along a straight line");
        case Frame:
            return point.priority == project::TargetKind::Joints
                       ? tr("Joints have priority: the arm returns to the same configuration")
                       : tr("The pose has priority: the waypoint moves with its frame");
        case ReachColumn:
            return !document_.reach(row).ok() ? reachAdvice(document_.reach(row))
                   : pathLimit(row).isEmpty() ? tr("Within reach")
                                              : pathLimit(row);
        default:
            return {};
    }
}

QVariant WaypointModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const project::Waypoint& point = waypointAt(index.row());
    const bool unreachable = index.column() == ReachColumn &&
                             (!document_.reach(index.row()).ok() || !pathLimit(index.row()).isEmpty());
    switch (role) {
        case Qt::DisplayRole:
            // The view displays the row number. As model data, it would change for all following rows with
            // every insertion.
            return index.column() == Number ? QVariant() : display(point, index.row(), index.column());
        case Qt::EditRole:
            if (index.column() == Speed) {
                return QString::number(point.move == project::MoveKind::Joint
                                           ? toDegrees(point.jointSpeed)
                                           : point.toolSpeed / format::metresPerUnit(),
                                       'g', 8);
            }
            return index.column() == Name ? point.name : display(point, index.row(), index.column());
        case Qt::ToolTipRole:
            return toolTip(point, index.row(), index.column());
        case Qt::AccessibleTextRole:
            if (index.column() == Name && (point.id == coming_ || !point.actions.empty())) {
                const auto count = static_cast<int>(point.actions.size());
                QStringList words{point.id == coming_ ? tr("Name %1, next waypoint").arg(point.name)
                                                      : tr("Name %1").arg(point.name)};
                if (count > 0) {
                    words << tr("%n actions", nullptr, count);
                }
                return words.join(QStringLiteral(", "));
            }
            return QStringLiteral("%1 %2").arg(
                headerData(index.column(), Qt::Horizontal, Qt::DisplayRole).toString(),
                display(point, index.row(), index.column()));
        case Qt::FontRole: {
            QFont font = index.column() == Speed ? numberFont(14) : textFont(15);
            font.setBold(unreachable || (index.column() == Name && point.id == coming_));
            return font;
        }
        case Qt::DecorationRole:
            return index.column() == Name && point.colour != project::WaypointColour::None
                       ? QVariant(colourOf(point.colour))
                       : QVariant();
        case Qt::ForegroundRole:
            return unreachable ? QVariant(Theme::current().warning) : QVariant();
        default:
            return {};
    }
}

QVariant WaypointModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
        case Number:
            return QStringLiteral("#");
        case Name:
            return tr("Name");
        case Move:
            return tr("Move");
        case Frame:
            return tr("Frame");
        case Speed:
            return tr("Speed");
        case Blend:
            return tr("Blend %1").arg(format::lengthUnit());
        case ReachColumn:
            return tr("Reach");
        default:
            return {};
    }
}

Qt::ItemFlags WaypointModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) {
        return Qt::ItemIsDropEnabled;  // drop only between rows
    }
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled;
    if (index.column() != Number && index.column() != ReachColumn) {
        flags |= Qt::ItemIsEditable;
    }
    return flags;
}

// ---- editing ---------------------------------------------------------------------------------------

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
            return setNumber(index.row(), index.column(), text);
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
        Q_EMIT editRefused(tr("Enter a name for the waypoint."));
        return false;
    }
    if (document_.waypoints().indexOfName(text) >= 0) {
        Q_EMIT editRefused(tr("Waypoint %2 is already named “%1”. Choose a different name.")
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
        (point.move == project::MoveKind::Joint ? tr("Change “%1” to MoveJ") : tr("Change “%1” to MoveL"))
            .arg(point.name));
    return true;
}

void WaypointModel::setPose(int row, const Pose& pose) {
    if (row < 0 || row >= rowCount()) {
        return;
    }
    project::Waypoint point = waypointAt(row);
    const bool joints = point.priority == project::TargetKind::Joints;
    std::optional<Pose> place = pose;
    if (!joints) {
        point.pose = pose;
        place = project::poseInBase(point, document_.frames());
    }
    const auto q =
        place ? kinematics::inverseNearest(document_.robot().dh, *place, point.tcpOffset, point.joints)
              : std::nullopt;
    if (joints) {
        const auto moved =
            q ? project::taughtAt(point, *q, *place, point.tcpOffset, document_.frames()) : std::nullopt;
        if (!moved) {
            Q_EMIT editRefused(
                tr("The arm cannot reach this pose, so “%1” was not changed. Enter a different pose.")
                    .arg(point.name));
            return;
        }
        point = *moved;
    } else if (q) {
        point.joints = *q;
    }
    document_.changeWaypoint(row, point, tr("Change the pose of “%1”").arg(point.name));
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
        // The joint positions of the current pose become the joint target.
        if (document_.reach(row).ok()) {
            point.joints = document_.reach(row).q;
        }
        point.priority = project::TargetKind::Joints;
        document_.changeWaypoint(row, point, tr("Use joint positions for “%1”").arg(point.name));
        return true;
    }
    const project::Frame* frame = document_.frames().findByName(text);
    if (frame == nullptr && text != tr("Base")) {
        Q_EMIT editRefused(tr("The project has no frame named “%1”. Choose a different frame.").arg(text));
        return false;
    }
    // Keep the position in the base frame.
    const std::optional<Pose> place =
        point.priority == project::TargetKind::Joints
            ? std::optional(kinematics::forwardTcp(document_.robot().dh, point.joints, point.tcpOffset))
            : project::poseInBase(point, document_.frames());
    point.priority = project::TargetKind::Pose;
    point.frame = frame == nullptr ? QUuid() : frame->id;
    if (place) {
        point = *project::taughtAt(point, point.joints, *place, point.tcpOffset, document_.frames());
    }
    document_.changeWaypoint(row, point, tr("Change the frame of “%1” to %2").arg(point.name, text));
    return true;
}

bool WaypointModel::setNumber(int row, int column, const QString& text) {
    project::Waypoint point = waypointAt(row);
    if (text == data(index(row, column), Qt::EditRole).toString()) {
        return true;  // an unchanged text keeps the full precision
    }
    const std::optional<double> figure = leadingNumber(text);
    if (!figure) {
        Q_EMIT editRefused(tr("“%1” is not a number. Enter a number.").arg(text));
        return false;
    }
    const bool turns = column == Speed && point.move == project::MoveKind::Joint;
    const double unit = turns ? toRadians(1) : format::metresPerUnit();
    const double value = *figure * unit;
    const double least = column == Blend ? 0 : turns ? toRadians(1) : kMinTcpSpeed;
    const double most = column == Blend ? kMaxBlendRadius
                        : turns         ? *std::min_element(document_.robot().maxJointSpeed.begin(),
                                                            document_.robot().maxJointSpeed.end())
                                        : kMaxTcpSpeed;
    if (value < least * (1 - 1e-9) || value > most * (1 + 1e-9)) {
        const auto shown = [&](double bound) {
            return turns             ? format::degreesPerSecond(bound)
                   : column == Blend ? format::shortLength(bound)
                                     : format::speed(bound);
        };
        Q_EMIT editRefused(tr("%1 is out of range. Enter a value from %2 to %3.")
                               .arg(shown(value), shown(least), shown(most)));
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

#include "moc_waypoint_model.cpp"
