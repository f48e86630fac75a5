// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Passes the cell of the project to the view, the session and a simulated controller: floor, boxes and
// planes, safety distance, and radius of the tool.

namespace tiller {

class ProjectDocument;
class RobotSession;
class SceneView;
namespace simulator {
class Simulator;
}

}  // namespace tiller

namespace tiller::app {

/// Updates the view and the session immediately and after each change of the document, as long as all of them
/// exist.
void followCell(SceneView& view, RobotSession& session, const ProjectDocument& document);
/// Replaces the objects around the simulated arm. Contact of its TCP with an object is simulated, and a large
/// force causes a protective stop.
/// Returns  the number of objects ignored because of the limited capacity
int simulateCell(simulator::Simulator& robot, const ProjectDocument& document);

}  // namespace tiller::app
