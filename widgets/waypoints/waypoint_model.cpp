// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/waypoint_model.h"

#include <algorithm>

#include "robot/core/angles.h"
#include "widgets/common/format.h"
#include "widgets/common/notation.h"
#include "widgets/common/theme.h"

namespace tiller {

WaypointModel::WaypointModel(ProjectDocument& document, QObject* parent)
    : QAbstractTableModel(parent), document_(document) {
    followDocument();
}

void WaypointModel::followDocument() {
    const ProjectDocument* document = &document_;
    connect(document, &ProjectDocument::projectAboutToBeReplaced, this, [this] { beginResetModel(); });
    connect(document, &ProjectDocument::projectReplaced, this, [this] { endResetModel(); });
    connect(document, &ProjectDocument::waypointAboutToBeInserted, this,
            [this](int row) { beginInsertRows({}, row, row); });
    connect(document, &ProjectDocument::waypointInserted, this, [this] { endInsertRows(); });
    connect(document, &ProjectDocument::waypointAboutToBeRemoved, this,
            [this](int row) { beginRemoveRows({}, row, row); });
    connect(document, &ProjectDocument::waypointRemoved, this, [this] { endRemoveRows(); });
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
        for (qsizetype i = 0; i < before.size(); ++i) {
            after.append(index(document_.waypoints().indexOf(orderBefore_[i]), before[i].column()));
        }
        changePersistentIndexList(before, after);
        Q_EMIT layoutChanged({}, VerticalSortHint);
    });
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
            return tr("Its frame is not in this project. Choose another frame.");
        case project::Reach::Obstacle::OnTheWay:
            return tr("The straight line from here leaves the arm's reach. Use MoveJ, or start elsewhere.");
        case project::Reach::Obstacle::OutOfReach:
            break;
    }
    return tr("Out of reach. Touch it up nearer to the base.");
}

// ---- the table's face ------------------------------------------------------------------------------

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
            return point.name;
        case Move:
            return point.move == project::MoveKind::Joint ? QStringLiteral("J") : QStringLiteral("L");
        case Frame: {
            if (point.ruling == project::Ruling::Joints) {
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
            return reachText(document_.reach(row));
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
            return document_.reach(row).ok() ? tr("Can be reached") : reachAdvice(document_.reach(row));
        default:
            return {};
    }
}

QVariant WaypointModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const project::Waypoint& point = waypointAt(index.row());
    const bool unreachable = index.column() == ReachColumn && !document_.reach(index.row()).ok();
    switch (role) {
        case Qt::DisplayRole:
            // A number would be other data after every insertion above it: the view writes it.
            return index.column() == Number ? QVariant() : display(point, index.row(), index.column());
        case Qt::EditRole:
            if (index.column() == Speed) {
                return QString::number(point.move == project::MoveKind::Joint
                                           ? toDegrees(point.jointSpeed)
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
