// SPDX-License-Identifier: MIT
#include "robot/station/document/cell_surroundings.h"

#include <optional>

namespace tiller {

collision::CellSurroundings surroundingsOf(const project::Project& project) {
    collision::CellSurroundings result;
    result.safetyDistance = project.cell.safetyDistance;
    if (const project::Tool* tool = project.tooling.tools.find(project.tooling.activeTool)) {
        result.toolRadius = tool->radius;
    }
    const auto inBase = [&](const QUuid& frame, const Pose& pose) -> std::optional<Pose> {
        const std::optional<Pose> T_base_frame = project.frames.pose(frame);
        return T_base_frame ? std::optional(Pose(T_base_frame->transform() * pose.transform()))
                            : std::nullopt;
    };
    if (project.cell.floor) {
        result.around.borders.push_back({{}, Pose(0, 0, *project.cell.floor, 0, 0, 0)});
    }
    for (const project::CellPlane& plane : project.cell.planes) {
        const auto pose = inBase(plane.frame, plane.pose);
        if (pose && plane.enabled) {
            result.around.borders.push_back({plane.name, *pose});
        }
    }
    for (const project::CellBox& box : project.cell.boxes) {
        const auto pose = inBase(box.frame, box.pose);
        if (pose && box.enabled) {
            result.around.obstacles.push_back({box.name, *pose, box.size});
        }
    }
    return result;
}

}  // namespace tiller
