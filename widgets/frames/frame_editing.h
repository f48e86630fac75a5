// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Edits frames by other means than teaching points: create, move together with their waypoints, duplicate and
// delete. Every step is an undoable edit of the document. Moving waypoints requires a confirmation.

#include <QObject>

#include "robot/project/waypoint.h"
#include "robot/station/link/robot_session.h"

namespace tiller {

class FrameModel;
class NoticeBar;
class ProjectDocument;

class FrameEditing : public QObject {
    Q_OBJECT

public:
    /// document, model, notice  must outlive the object; the questions are shown in `notice`
    FrameEditing(ProjectDocument& document, FrameModel& model, NoticeBar& notice, QObject* parent = nullptr);

    void insert(const Pose& T_base_frame);
    /// Asks for confirmation. The question shows how the frame and its waypoints would move.
    void askToMove(const QUuid& id, const Pose& T_base_frame);
    /// Moves a frame to a manually entered pose without confirmation.
    void place(const project::Frame& frame, const Pose& T_base_frame);
    void duplicate(const project::Frame& frame);
    /// Asks for confirmation if waypoints are in this frame.
    void remove(const project::Frame& frame);

Q_SIGNALS:
    /// A message for the log.
    void message(tiller::Severity severity, const QString& text);

private:
    /// Returns  a description of the moved waypoints
    QString move(const QUuid& id, const Pose& T_base_frame, const QString& step);

    ProjectDocument& document_;
    FrameModel& model_;
    NoticeBar& notice_;
};

}  // namespace tiller
