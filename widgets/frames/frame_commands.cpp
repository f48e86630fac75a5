// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/frames/frame_commands.h"

#include "widgets/waypoints/waypoint_model.h"

namespace tiller {

EditFrames::EditFrames(WaypointModel& model, project::FrameList after, const QString& text)
    : QUndoCommand(text), model_(model), before_(model.frames()), after_(std::move(after)) {}

void EditFrames::redo() {
    model_.setFramesRaw(after_);
}

void EditFrames::undo() {
    model_.setFramesRaw(before_);
}

}  // namespace tiller
