// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Gives the view what the project knows of the cell: floor, boxes and planes, and how thick the tool is.

namespace tiller {

class ProjectDocument;
class SceneView;

}  // namespace tiller

namespace tiller::app {

/// Now and after each change, as long as both live.
void followCell(SceneView& view, const ProjectDocument& document);

}  // namespace tiller::app
