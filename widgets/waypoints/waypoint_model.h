// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Table model of the project's waypoints. Editing and dragging change the document.

#include <QAbstractTableModel>
#include <QHash>

#include "robot/project/reachability.h"
#include "robot/station/document/project_document.h"

namespace tiller {

class WaypointModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Number, Name, Move, Frame, Speed, Blend, ReachColumn, ColumnCount };

    /// document  must outlive the model
    explicit WaypointModel(ProjectDocument& document, QObject* parent = nullptr);

    /// The choices for the frame column: "—" (joint target), "Base" and the taught frames.
    QStringList frameChoices() const;

    /// Sets the position of the waypoint in its frame or, for a joint target, in the base frame. The joint
    /// positions become the nearest solution. An unreachable position is refused for a joint target. For a
    /// pose target, it is accepted and marked.
    void setPose(int row, const Pose& pose);

    /// Highlights the next waypoint of the route; null removes the highlight.
    void setComing(const QUuid& id);
    /// Sets the reason why the arm may not move from its current position to this waypoint, as a sentence;
    /// empty if the move is permitted.
    void setPathLimit(const QUuid& id, const QString& limit);
    QString pathLimit(int row) const { return pathLimits_.value(waypointAt(row).id); }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    QStringList mimeTypes() const override;
    QMimeData* mimeData(const QModelIndexList& indexes) const override;
    bool canDropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                         const QModelIndex& parent) const override;
    bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                      const QModelIndex& parent) override;

Q_SIGNALS:
    /// An edit was refused for this reason.
    void editRefused(const QString& reason);

private:
    QString display(const project::Waypoint& point, int row, int column) const;
    QString toolTip(const project::Waypoint& point, int row, int column) const;
    bool setName(int row, const QString& text);
    bool setMove(int row, const QString& text);
    bool setFrame(int row, const QString& text);
    bool setNumber(int row, int column, const QString& text);
    void followDocument();
    const project::Waypoint& waypointAt(int row) const { return document_.waypoints().at(row); }

    ProjectDocument& document_;
    QUuid coming_;
    QHash<QUuid, QString> pathLimits_;  ///< contains only non-empty texts
    QVector<QUuid> orderBefore_;        ///< waypoint of each persistent index before a reordering
};

}  // namespace tiller
