// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/frames/frame_model.h"

#include <algorithm>

#include "robot/project/reachability.h"
#include "robot/station/document/project_document.h"
#include "robot/station/text/notation.h"
#include "widgets/common/theme.h"

namespace tiller {

FrameModel::FrameModel(ProjectDocument& document, QObject* parent)
    : QAbstractTableModel(parent), document_(document) {
    connect(&document_, &ProjectDocument::framesChanged, this, &FrameModel::follow);
    // The numbers of waypoints change if a waypoint is assigned to another frame.
    connect(&document_, &ProjectDocument::documentChanged, this, [this] {
        if (rowCount() > 0) {
            Q_EMIT dataChanged(index(0, Waypoints), index(rowCount() - 1, Waypoints));
        }
    });
    follow();
}

const project::FrameList& FrameModel::frames() const {
    return document_.frames();
}

void FrameModel::follow() {
    QVector<QUuid> ids;
    for (const project::Frame& frame : frames()) {
        ids.append(frame.id);
    }
    if (ids == ids_) {
        if (!ids.isEmpty()) {
            Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
        }
        return;
    }
    beginResetModel();
    ids_ = ids;
    endResetModel();
}

int FrameModel::rowOf(const QUuid& id) const {
    return static_cast<int>(ids_.indexOf(id));
}

FrameUse FrameModel::use(const QUuid& id, const Pose& T_base_frame) const {
    project::FrameList moved = frames();
    if (const int row = rowOf(id); row >= 0) {
        project::Frame frame = moved.at(static_cast<std::size_t>(row));
        frame.T_base_frame = T_base_frame;
        moved.replace(static_cast<std::size_t>(row), frame);
    }
    FrameUse use;
    for (const project::Waypoint& point : document_.waypoints()) {
        if (project::movesWith(point, id)) {
            ++use.waypoints;
            use.outOfReach += project::reach(document_.robot(), point, moved).ok() ? 0 : 1;
        }
    }
    return use;
}

void FrameModel::setTcp(const std::optional<Pose>& T_base_tcp) {
    if (T_base_tcp == tcp_) {
        return;
    }
    tcp_ = T_base_tcp;
    if (rowCount() > 0) {
        Q_EMIT dataChanged(index(0, Distance), index(rowCount() - 1, Distance));
    }
}

// ---- editing ---------------------------------------------------------------------------------------

QString FrameModel::nameProblem(const QString& name, const QUuid& own) const {
    if (name.trimmed().isEmpty()) {
        return tr("Enter a name for the frame.");
    }
    const QStringList reserved = {QStringLiteral("Base"),
                                  QStringLiteral("Tool"),
                                  QStringLiteral("View"),
                                  tr("Base"),
                                  tr("Tool"),
                                  tr("View"),
                                  QStringLiteral("—")};
    if (reserved.contains(name, Qt::CaseInsensitive)) {
        return tr("“%1” is a built-in frame. Choose a different name.").arg(name);
    }
    for (const project::Frame& frame : frames()) {
        if (frame.id != own && frame.name.compare(name, Qt::CaseInsensitive) == 0) {
            return tr("A frame named “%1” already exists. Choose a different name.").arg(name);
        }
    }
    return {};
}

bool FrameModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !index.isValid() || index.row() >= rowCount() || index.column() != Name) {
        return false;
    }
    project::Frame frame = frames().at(static_cast<std::size_t>(index.row()));
    const QString name = value.toString().trimmed();
    if (name == frame.name) {
        return true;
    }
    if (const QString problem = nameProblem(name, frame.id); !problem.isEmpty()) {
        Q_EMIT editRefused(problem);
        return false;
    }
    const QString text = tr("Rename “%1” to “%2”").arg(frame.name, name);
    frame.name = name;
    document_.changeFrame(index.row(), frame, text);
    return true;
}

// ---- table -----------------------------------------------------------------------------------------

int FrameModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(ids_.size());
}

int FrameModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString FrameModel::display(const project::Frame& frame, int column) const {
    const auto three = [](const QString& a, const QString& b, const QString& c) {
        return QStringLiteral("%1 %2 %3").arg(a, b, c);
    };
    switch (column) {
        case Name:
            return frame.name;
        case Origin: {
            const Eigen::Vector3d& p = frame.T_base_frame.position;
            return three(format::lengthNumber(p.x(), 1, false), format::lengthNumber(p.y(), 1, false),
                         format::lengthNumber(p.z(), 1, false));
        }
        case Rotation: {
            const std::array<QString, 3> turns = format::rotationNumbers(frame.T_base_frame.rotation);
            return three(turns[0], turns[1], turns[2]);
        }
        case Waypoints:
            return QString::number(
                std::count_if(document_.waypoints().begin(), document_.waypoints().end(),
                              [&](const auto& point) { return project::movesWith(point, frame.id); }));
        case Distance:
            return tcp_
                       ? format::lengthNumber((frame.T_base_frame.position - tcp_->position).norm(), 1, false)
                       : QStringLiteral("–");
        default:
            return {};
    }
}

QVariant FrameModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const project::Frame& frame = frames().at(static_cast<std::size_t>(index.row()));
    const int column = index.column();
    switch (role) {
        case Qt::DisplayRole:
        case Qt::EditRole:
            return display(frame, column);
        case Qt::ToolTipRole:
            return column == Name ? frame.name
                                  : headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString() +
                                        QStringLiteral(": ") + display(frame, column);
        case Qt::AccessibleTextRole:
            return QStringLiteral("%1 %2").arg(headerData(column, Qt::Horizontal, Qt::DisplayRole).toString(),
                                               display(frame, column));
        case Qt::FontRole:
            return column == Name || column == Waypoints ? textFont(15) : numberFont(13);
        default:
            return {};
    }
}

QVariant FrameModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    }
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) {
        return {};
    }
    const bool shortly = role == Qt::DisplayRole;
    const bool vector = Notation::current().rotation == RotationNotation::RotationVector;
    switch (section) {
        case Name:
            return tr("Name");
        case Origin:
            return (shortly ? tr("Origin %1") : tr("Origin in Base, X Y Z, %1")).arg(format::lengthUnit());
        case Rotation:
            return shortly  ? (vector ? tr("Rotation, rad") : tr("Rotation"))
                   : vector ? tr("Rotation vector in Base, radians")
                            : tr("Roll, pitch and yaw in Base");
        case Waypoints:
            return shortly ? tr("Points") : tr("Waypoints that move with the frame");
        case Distance:
            return (shortly ? tr("TCP %1") : tr("Distance from the TCP, %1")).arg(format::lengthUnit());
        default:
            return {};
    }
}

Qt::ItemFlags FrameModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) {
        return Qt::NoItemFlags;
    }
    const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    return index.column() == Name ? flags | Qt::ItemIsEditable : flags;
}

}  // namespace tiller

#include "moc_frame_model.cpp"
