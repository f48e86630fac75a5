// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Table model of the project's frames. Editing changes the document.

#include <QAbstractTableModel>
#include <optional>

#include "robot/project/waypoint_list.h"

namespace tiller {

class ProjectDocument;

/// Effect of moving the frame on its waypoints.
struct FrameUse {
    int waypoints = 0;
    int outOfReach = 0;  ///< number of unreachable waypoints
};

class FrameModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, Origin, Rotation, Waypoints, Distance, ColumnCount };

    /// document  must outlive the model
    explicit FrameModel(ProjectDocument& document, QObject* parent = nullptr);

    const project::FrameList& frames() const;
    /// Returns -1 if the frame does not exist.
    int rowOf(const QUuid& id) const;
    /// Returns the number of waypoints that move with the frame, and how many of them would be unreachable if
    /// the frame were at `T_base_frame`.
    FrameUse use(const QUuid& id, const Pose& T_base_frame) const;
    FrameUse use(const project::Frame& frame) const { return use(frame.id, frame.T_base_frame); }
    /// Sets the TCP pose for the distance column; empty if there are no data.
    void setTcp(const std::optional<Pose>& T_base_tcp);

    /// Returns the reason why a frame cannot have this name, as a sentence; empty if the name is valid.
    QString nameProblem(const QString& name, const QUuid& own = {}) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

Q_SIGNALS:
    /// An edit was refused for this reason.
    void editRefused(const QString& reason);

private:
    void follow();
    QString display(const project::Frame& frame, int column) const;

    ProjectDocument& document_;
    QVector<QUuid> ids_;  ///< IDs of the rows in the views
    std::optional<Pose> tcp_;
};

}  // namespace tiller
