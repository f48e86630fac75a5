// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A change of the session's frames, with its way back. There are few frames: the whole list is kept.

#include <QUndoCommand>

#include "robot/project/waypoint_list.h"

namespace tiller {

class WaypointModel;

class EditFrames : public QUndoCommand {
public:
    EditFrames(WaypointModel& model, project::FrameList after, const QString& text);
    void redo() override;
    void undo() override;

private:
    WaypointModel& model_;
    project::FrameList before_;
    project::FrameList after_;
};

}  // namespace tiller
