// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The frames of the project as a table. What is typed in it becomes an edit of the document.

#include <QAbstractTableModel>
#include <optional>

#include "robot/project/waypoint_list.h"

namespace tiller {

class ProjectDocument;

/// What a frame's other place would do to the waypoints that move with it.
struct FrameUse {
    int waypoints = 0;
    int outOfReach = 0;  ///< of those
};

class FrameModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, Origin, Rotation, Waypoints, Distance, ColumnCount };

    /// document  must outlive the model
    explicit FrameModel(ProjectDocument& document, QObject* parent = nullptr);

    const project::FrameList& frames() const;
    /// -1 when there is none.
    int rowOf(const QUuid& id) const;
    /// How many waypoints move with it, and how many of them could not be reached if it stood at
    /// `T_base_frame`.
    FrameUse use(const QUuid& id, const Pose& T_base_frame) const;
    FrameUse use(const project::Frame& frame) const { return use(frame.id, frame.T_base_frame); }
    /// For the column of distances; nothing while there are no data.
    void setTcp(const std::optional<Pose>& T_base_tcp);

    /// Why a frame cannot have that name, as a sentence; empty when it can.
    QString nameProblem(const QString& name, const QUuid& own = {}) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

Q_SIGNALS:
    /// An edit was refused, and why.
    void editRefused(const QString& reason);

private:
    void follow();
    QString display(const project::Frame& frame, int column) const;

    ProjectDocument& document_;
    QVector<QUuid> ids_;  ///< as the views know them
    std::optional<Pose> tcp_;
};

}  // namespace tiller
