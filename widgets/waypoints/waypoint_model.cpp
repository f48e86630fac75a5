// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/waypoint_model.h"

#include <algorithm>
#include <numbers>

#include "widgets/common/format.h"
#include "widgets/common/notation.h"
#include "widgets/common/theme.h"
#include "widgets/project/project_commands.h"

namespace tiller {
namespace {

constexpr double kDegPerRad = 180.0 / std::numbers::pi;

}  // namespace

WaypointModel::WaypointModel(QObject* parent)
    : QAbstractTableModel(parent), robot_(&robotModel(RobotModelId::UR5e)) {}

void WaypointModel::setRobot(RobotModelId robot) {
    if (robot_->id == robot) {
        return;
    }
    robot_ = &robotModel(robot);
    refreshReach();
    if (rowCount() > 0) {
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    }
}

void WaypointModel::setDocument(project::Project document) {
    beginResetModel();
    document_ = std::move(document);
    refreshReach();
    endResetModel();
    undo_.clear();
    Q_EMIT framesChanged();
    Q_EMIT documentChanged();
}

void WaypointModel::refreshReach() {
    reach_.clear();
    for (const project::Waypoint& point : document_.waypoints) {
        reach_.push_back(project::reach(*robot_, point, document_.frames));
    }
}

QString WaypointModel::reachText(const project::Reach& reach) {
    switch (reach.obstacle) {
        case project::Reach::Obstacle::None:
            return QStringLiteral("✓");
        case project::Reach::Obstacle::JointLimit:
            return tr("✕ joint");
        case project::Reach::Obstacle::FrameMissing:
            return tr("✕ frame");
        case project::Reach::Obstacle::OutOfReach:
            break;
        case project::Reach::Obstacle::OnTheWay:
            return tr("✕ line");
    }
    return tr("✕ reach");
}

QString WaypointModel::reachAdvice(const project::Reach& reach) {
    switch (reach.obstacle) {
        case project::Reach::Obstacle::None:
            return {};
        case project::Reach::Obstacle::JointLimit:
            return tr("A joint would leave its range. Touch the waypoint up from another arm posture.");
        case project::Reach::Obstacle::FrameMissing:
            return tr("Its frame is not in this session. Choose another frame.");
        case project::Reach::Obstacle::OnTheWay:
            return tr("The straight line from here leaves the arm's reach. Use MoveJ, or start elsewhere.");
        case project::Reach::Obstacle::OutOfReach:
            break;
    }
    return tr("Out of reach. Touch it up nearer to the base.");
}

// ---- edits by hand ---------------------------------------------------------------------------------

void WaypointModel::insert(int row, const std::vector<project::Waypoint>& waypoints, const QString& text) {
    if (!waypoints.empty()) {
        undo_.push(new InsertWaypoints(*this, std::clamp(row, 0, rowCount()), waypoints, text));
    }
}

void WaypointModel::remove(QList<int> rows) {
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    rows.removeIf([this](int row) { return row < 0 || row >= rowCount(); });
    if (rows.isEmpty()) {
        return;
    }
    const QString text = rows.size() == 1 ? tr("Delete “%1”").arg(document_.waypoints.at(rows.first()).name)
                                          : tr("Delete %1 waypoints").arg(rows.size());
    undo_.push(new RemoveWaypoints(*this, rows, text));
}

void WaypointModel::change(int row, const project::Waypoint& waypoint, const QString& text) {
    if (!(document_.waypoints.at(row) == waypoint)) {
        undo_.push(new ChangeWaypoint(*this, row, waypoint, text));
    }
}

void WaypointModel::reorder(const QVector<QUuid>& order) {
    undo_.push(new ReorderWaypoints(*this, order, tr("Change the order")));
}

void WaypointModel::moveRowsBefore(const QList<int>& rows, int before) {
    QVector<QUuid> front;
    QVector<QUuid> moved;
    QVector<QUuid> back;
    QVector<QUuid> old;
    for (int row = 0; row < rowCount(); ++row) {
        const QUuid id = document_.waypoints.at(row).id;
        old.append(id);
        (rows.contains(row) ? moved : row < before ? front : back).append(id);
    }
    const QVector<QUuid> order = front + moved + back;
    if (order != old) {
        reorder(order);
    }
}

// ---- for commands ----------------------------------------------------------------------------------

void WaypointModel::insertRaw(int row, const project::Waypoint& waypoint) {
    beginInsertRows({}, row, row);
    document_.waypoints.insert(row, waypoint);
    reach_.insert(reach_.begin() + row, project::reach(*robot_, waypoint, document_.frames));
    endInsertRows();
    Q_EMIT documentChanged();
}

project::Waypoint WaypointModel::takeRaw(int row) {
    beginRemoveRows({}, row, row);
    project::Waypoint taken = document_.waypoints.take(row);
    reach_.erase(reach_.begin() + row);
    endRemoveRows();
    Q_EMIT documentChanged();
    return taken;
}

void WaypointModel::replaceRaw(int row, const project::Waypoint& waypoint) {
    document_.waypoints.replace(row, waypoint);
    reach_.at(static_cast<std::size_t>(row)) = project::reach(*robot_, waypoint, document_.frames);
    Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
    Q_EMIT documentChanged();
}

void WaypointModel::reorderRaw(const QVector<QUuid>& order) {
    Q_EMIT layoutAboutToBeChanged({}, VerticalSortHint);
    const QModelIndexList before = persistentIndexList();
    QVector<QUuid> ids;
    for (const QModelIndex& old : before) {
        ids.append(document_.waypoints.at(old.row()).id);
    }
    project::WaypointList sorted;
    for (const QUuid& id : order) {
        sorted.append(document_.waypoints.at(document_.waypoints.indexOf(id)));
    }
    document_.waypoints = sorted;
    refreshReach();
    QModelIndexList after;
    for (qsizetype i = 0; i < before.size(); ++i) {
        after.append(index(document_.waypoints.indexOf(ids[i]), before[i].column()));
    }
    changePersistentIndexList(before, after);
    Q_EMIT layoutChanged({}, VerticalSortHint);
    Q_EMIT documentChanged();
}

void WaypointModel::setFramesRaw(const project::FrameList& frames) {
    document_.frames = frames;
    refreshReach();
    if (rowCount() > 0) {
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    }
    Q_EMIT framesChanged();
    Q_EMIT documentChanged();
}

// ---- the table's face ------------------------------------------------------------------------------

int WaypointModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : document_.waypoints.size();
}

int WaypointModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString WaypointModel::display(const project::Waypoint& point, int row, int column) const {
    switch (column) {
        case Number:
            return QString::number(row + 1);
        case Name:
            return point.name;
        case Move:
            return point.move == project::MoveKind::Joint ? QStringLiteral("J") : QStringLiteral("L");
        case Frame: {
            if (point.ruling == project::Ruling::Joints) {
                return QStringLiteral("—");
            }
            const project::Frame* frame = document_.frames.find(point.frame);
            return point.frame.isNull() ? tr("Base") : frame != nullptr ? frame->name : tr("missing");
        }
        case Speed:
            return point.move == project::MoveKind::Joint ? format::degreesPerSecond(point.jointSpeed)
                                                          : format::speed(point.toolSpeed);
        case Blend:
            return QString::number(point.blend / format::metresPerUnit(), 'g', 6);
        case ReachColumn:
            return reachText(reach(row));
        default:
            return {};
    }
}

QString WaypointModel::toolTip(const project::Waypoint& point, int row, int column) const {
    switch (column) {
        case Name:
            return point.name;
        case Move:
            return point.move == project::MoveKind::Joint ? tr("MoveJ: all joints start and stop together")
                                                          : tr("MoveL: the TCP goes along a straight line");
        case Frame:
            return point.ruling == project::Ruling::Joints
                       ? tr("The joints rule: the arm comes back in the same posture")
                       : tr("The pose rules: it moves with its frame");
        case ReachColumn:
            return reach(row).ok() ? tr("Can be reached") : reachAdvice(reach(row));
        default:
            return {};
    }
}

QVariant WaypointModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const project::Waypoint& point = document_.waypoints.at(index.row());
    const bool unreachable = index.column() == ReachColumn && !reach(index.row()).ok();
    switch (role) {
        case Qt::DisplayRole:
            // A number would be other data after every insertion above it: the view writes it.
            return index.column() == Number ? QVariant() : display(point, index.row(), index.column());
        case Qt::EditRole:
            if (index.column() == Speed) {
                return QString::number(point.move == project::MoveKind::Joint
                                           ? point.jointSpeed * kDegPerRad
                                           : point.toolSpeed / format::metresPerUnit(),
                                       'g', 8);
            }
            return display(point, index.row(), index.column());
        case Qt::ToolTipRole:
            return toolTip(point, index.row(), index.column());
        case Qt::AccessibleTextRole:
            return QStringLiteral("%1 %2").arg(
                headerData(index.column(), Qt::Horizontal, Qt::DisplayRole).toString(),
                display(point, index.row(), index.column()));
        case Qt::FontRole: {
            QFont font = index.column() == Speed ? figureFont(14) : textFont(15);
            font.setBold(unreachable);
            return font;
        }
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
        return Qt::ItemIsDropEnabled;  // between rows only
    }
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled;
    if (index.column() != Number && index.column() != ReachColumn) {
        flags |= Qt::ItemIsEditable;
    }
    return flags;
}

}  // namespace tiller
