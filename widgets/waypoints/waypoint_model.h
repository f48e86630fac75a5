// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The waypoints of the session as a table. Holds the document; every change by hand goes through an undo
// command, and the commands alone use the functions under "For commands".

#include <QAbstractTableModel>
#include <QUndoStack>
#include <vector>

#include "robot/core/robot_model.h"
#include "robot/project/project_file.h"
#include "robot/project/reachability.h"

namespace tiller {

class WaypointModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Number, Name, Move, Frame, Speed, Blend, ReachColumn, ColumnCount };

    explicit WaypointModel(QObject* parent = nullptr);

    const project::Project& document() const { return document_; }
    const project::WaypointList& waypoints() const { return document_.waypoints; }
    const project::FrameList& frames() const { return document_.frames; }
    const RobotModel& robot() const { return *robot_; }
    /// Reach depends on the arm.
    void setRobot(RobotModelId robot);
    QUndoStack& undoStack() { return undo_; }

    /// Another document; the history is empty afterwards.
    void setDocument(project::Project document);
    const project::Reach& reach(int row) const { return reach_.at(static_cast<std::size_t>(row)); }
    /// What stands in the column Reach: "✓", "✕ reach", "✕ joint", "✕ frame".
    static QString reachText(const project::Reach& reach);
    /// As a sentence with what to do; empty when it can be reached.
    static QString reachAdvice(const project::Reach& reach);

    // Edits by hand: one undo step each.
    void insert(int row, const std::vector<project::Waypoint>& waypoints, const QString& text);
    void remove(QList<int> rows);
    /// Does nothing when `waypoint` is as it was.
    void change(int row, const project::Waypoint& waypoint, const QString& text);
    /// order  of the ids after the step
    void reorder(const QVector<QUuid>& order);
    /// Moves the rows, in their order, in front of row `before`.
    void moveRowsBefore(const QList<int>& rows, int before);

    /// The names a frame column can hold: "—" (the joints rule), "Base" and the taught frames.
    QStringList frameChoices() const;

    // For commands.
    void insertRaw(int row, const project::Waypoint& waypoint);
    project::Waypoint takeRaw(int row);
    void replaceRaw(int row, const project::Waypoint& waypoint);
    void reorderRaw(const QVector<QUuid>& order);
    /// Every waypoint's frame must be among them.
    void setFramesRaw(const project::FrameList& frames);

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
    /// Anything in the document is different now.
    void documentChanged();
    /// The frames are others, or stand elsewhere.
    void framesChanged();
    /// Rows that were added or put back, to select them.
    void rowsAppeared(int first, int last);
    /// An edit was refused, and why.
    void editRefused(const QString& reason);

private:
    QString display(const project::Waypoint& point, int row, int column) const;
    QString toolTip(const project::Waypoint& point, int row, int column) const;
    bool setName(int row, const QString& text);
    bool setMove(int row, const QString& text);
    bool setFrame(int row, const QString& text);
    bool setFigure(int row, int column, const QString& text);
    void refreshReach();

    project::Project document_;
    std::vector<project::Reach> reach_;
    const RobotModel* robot_;
    QUndoStack undo_;
};

}  // namespace tiller
