// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is done to frames apart from taking points: make one, move one with what is given in it, duplicate and
// delete. Every step is one edit of the document, which can be undone; what moves waypoints is asked first.

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
    /// document, model, notice  must outlive it; notice is where it asks
    FrameEditing(ProjectDocument& document, FrameModel& model, NoticeBar& notice, QObject* parent = nullptr);

    /// A new frame, behind the others.
    void insert(const Pose& T_base_frame);
    /// Says how the frame would move and what moves with it, and asks.
    void askToMove(const QUuid& id, const Pose& T_base_frame);
    /// A place entered by hand: the frame is moved at once.
    void place(const project::Frame& frame, const Pose& T_base_frame);
    void duplicate(const project::Frame& frame);
    /// Asks when waypoints are given in it.
    void remove(const project::Frame& frame);

Q_SIGNALS:
    /// Something the operator should be able to read again later.
    void message(tiller::Severity severity, const QString& text);

private:
    /// Returns  what moved with it, in words
    QString move(const QUuid& id, const Pose& T_base_frame, const QString& step);

    ProjectDocument& document_;
    FrameModel& model_;
    NoticeBar& notice_;
};

}  // namespace tiller
