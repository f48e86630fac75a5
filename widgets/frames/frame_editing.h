// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Creates, moves, duplicates and deletes frames. FrameTeacher teaches their points. Waypoints move with their
// frame. Every step is an undoable edit of the document. Moving waypoints by a touch-up requires a
// confirmation.

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
    /// document, model, notice  must outlive the object; `notice` shows the questions
    FrameEditing(ProjectDocument& document, FrameModel& model, NoticeBar& notice, QObject* parent = nullptr);

    void insert(const Pose& T_base_frame);
    /// Asks for confirmation before moving the frame. The question shows how the frame and its waypoints
    /// would move.
    void askToMove(const QUuid& id, const Pose& T_base_frame);
    /// Moves a frame to an entered pose, without confirmation.
    void place(const project::Frame& frame, const Pose& T_base_frame);
    void duplicate(const project::Frame& frame);
    /// Asks for confirmation if the frame contains waypoints.
    void remove(const project::Frame& frame);

Q_SIGNALS:
    /// A message for the log.
    void message(tiller::Severity severity, const QString& text);

private:
    /// Returns  a text about the moved waypoints
    QString move(const QUuid& id, const Pose& T_base_frame, const QString& step);

    ProjectDocument& document_;
    FrameModel& model_;
    NoticeBar& notice_;
};

}  // namespace tiller
