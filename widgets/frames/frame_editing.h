// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Creates, moves, duplicates and deletes frames. FrameTeacher teaches their points. Waypoints move with their
// frame. Every change is an undoable edit of the document. Moving waypoints by a touch-up requires a
// confirmation.

#include <QObject>
#include <functional>
#include <optional>

#include "robot/project/waypoint.h"
#include "robot/station/journal/journal.h"
#include "robot/station/link/robot_session.h"
#include "widgets/frames/frame_model.h"

namespace tiller {

class NoticeBar;
class ProjectDocument;

class FrameEditing : public QObject {
    Q_OBJECT

public:
    /// document, model, notice, journal  must outlive the object; `notice` shows the questions
    FrameEditing(ProjectDocument& document, FrameModel& model, NoticeBar& notice, Journal& journal,
                 QObject* parent = nullptr);

    /// The new pose of a frame. `obstacle` is the reason why the pose cannot be stored now; empty if it can
    /// be stored.
    struct NewPose {
        Pose T_base_frame;
        QString obstacle = {};
    };
    using PoseSource = std::function<NewPose()>;

    void insert(const Pose& T_base_frame);
    /// Asks for confirmation before moving the frame. The question shows how the frame and its waypoints
    /// would move, and follows the pose. The pose at the confirmation is stored.
    void askToMove(const QUuid& id, const PoseSource& T_base_frame);
    /// Moves a frame to an entered pose, without confirmation.
    void place(const project::Frame& frame, const Pose& T_base_frame);
    void duplicate(const project::Frame& frame);
    /// Asks for confirmation if the frame contains waypoints.
    void remove(const project::Frame& frame);

private:
    QString moveText(const QUuid& id, const Pose& T_base_frame);
    /// Returns  a text about the moved waypoints
    QString move(const QUuid& id, const Pose& T_base_frame, const QString& step);

    /// Result of the last check of a move. It is stored, because checking the reach of all waypoints takes
    /// too long for each update of a question.
    struct CheckedMove {
        QUuid id;
        Pose T_base_frame;
        FrameUse use;
    };
    FrameUse useAt(const QUuid& id, const Pose& T_base_frame);

    ProjectDocument& document_;
    FrameModel& model_;
    NoticeBar& notice_;
    std::optional<CheckedMove> checked_;
    Journal& journal_;
};

}  // namespace tiller
