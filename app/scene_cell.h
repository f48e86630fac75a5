// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Gives the view, the session and a simulated controller what the project knows of the cell: floor, boxes and planes,
// the safety distance, and how thick the tool is.

namespace tiller {

class ProjectDocument;
class RobotSession;
class SceneView;
namespace simulator {
class Simulator;
}

}  // namespace tiller

namespace tiller::app {

/// Now and after each change, as long as both live.
void followCell(SceneView& view, RobotSession& session, const ProjectDocument& document);
/// The same things stand around the simulated arm, and nothing else: its TCP touches them, and what presses too
/// hard is a protective stop.
/// Returns  how many it had no room for
int simulateCell(simulator::Simulator& robot, const ProjectDocument& document);

}  // namespace tiller::app
