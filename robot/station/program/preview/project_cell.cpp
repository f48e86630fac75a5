// SPDX-License-Identifier: MIT
#include "robot/station/program/preview/project_cell.h"

namespace tiller::program {

collision::CellSurroundings cellSurroundings(const project::CellGeometry& cell,
                                             const project::FrameList& frames,
                                             const project::Tooling& tooling) {
    collision::CellSurroundings result;
    const auto inBase = [&](const QUuid& frame, const Pose& pose) -> std::optional<Pose> {
        const std::optional<Pose> T_base_frame = frames.pose(frame);
        return T_base_frame ? std::optional(*T_base_frame * pose) : std::nullopt;
    };
    if (cell.floor) {
        result.around.borders.push_back({{}, Pose(0, 0, *cell.floor, 0, 0, 0)});
    }
    for (const project::CellPlane& plane : cell.planes) {
        const auto pose = inBase(plane.frame, plane.pose);
        if (pose && plane.enabled) {
            result.around.borders.push_back({plane.name, *pose});
        }
    }
    for (const project::CellBox& box : cell.boxes) {
        const auto pose = inBase(box.frame, box.pose);
        if (pose && box.enabled) {
            result.around.obstacles.push_back({box.name, *pose, box.size});
        }
    }
    if (const project::Tool* tool = tooling.tools.find(tooling.activeTool)) {
        result.toolRadius = tool->radius;
    }
    result.safetyDistance = cell.safetyDistance;
    return result;
}

}  // namespace tiller::program
