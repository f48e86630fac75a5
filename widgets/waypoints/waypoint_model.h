// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The waypoints of the project as a table. What is typed or dragged in it becomes an edit of the document.

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

    /// The names a frame column can hold: "—" (the joints rule), "Base" and the taught frames.
    QStringList frameChoices() const;

    /// The waypoint shall be here: in its frame, or in Base where the joints rule. Its joints become those of the
    /// nearest posture that gets there. A place out of reach is kept, marked, where the pose rules, and refused
    /// where the joints do.
    void setPose(int row, const Pose& pose);

    /// The waypoint that the arm goes to next, to be seen as such; null for none.
    void setComing(const QUuid& id);
    /// Why the arm would be refused to go there from where it is, as a sentence; empty: nothing is in the way.
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
    /// An edit was refused, and why.
    void editRefused(const QString& reason);

private:
    QString display(const project::Waypoint& point, int row, int column) const;
    QString toolTip(const project::Waypoint& point, int row, int column) const;
    bool setName(int row, const QString& text);
    bool setMove(int row, const QString& text);
    bool setFrame(int row, const QString& text);
    bool setFigure(int row, int column, const QString& text);
    void followDocument();
    const project::Waypoint& waypointAt(int row) const { return document_.waypoints().at(row); }

    ProjectDocument& document_;
    QUuid coming_;
    QHash<QUuid, QString> pathLimits_;  ///< of those that have one
    QVector<QUuid> orderBefore_;        ///< of the persistent indexes, while the order changes
};

}  // namespace tiller
