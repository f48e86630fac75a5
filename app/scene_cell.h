// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Passes the cell of the project to the view and a simulated controller: floor, boxes and planes, safety
// distance, and radius of the tool.

namespace tiller {

class ProjectDocument;
class SceneView;
namespace simulator {
class Simulator;
}

}  // namespace tiller

namespace tiller::app {

/// Updates the view immediately and after each change of the document, as long as both exist.
void followCell(SceneView& view, const ProjectDocument& document);
/// Replaces the objects around the simulated arm. Contact of its TCP with an object is simulated, and a large
/// force causes a protective stop.
/// Returns  the number of objects ignored because of the limited capacity
int simulateCell(simulator::Simulator& robot, const ProjectDocument& document);

}  // namespace tiller::app
