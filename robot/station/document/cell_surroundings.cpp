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
    /// The pose in the base frame; empty if the part is disabled or its frame is unknown.
    const auto inBase = [&](const auto& part) -> std::optional<Pose> {
        if (!part.enabled) {
            return std::nullopt;
        }
        const std::optional<Pose> T_base_frame = project.frames.pose(part.frame);
        if (!T_base_frame) {
            result.unplaced.push_back({part.name, part.frame.toString(QUuid::WithoutBraces)});
            return std::nullopt;
        }
        return Pose(T_base_frame->transform() * part.pose.transform());
    };
    if (project.cell.floor) {
        result.around.borders.push_back({{}, Pose(0, 0, *project.cell.floor, 0, 0, 0)});
    }
    for (const project::CellPlane& plane : project.cell.planes) {
        if (const auto pose = inBase(plane)) {
            result.around.borders.push_back({plane.name, *pose});
        }
    }
    for (const project::CellBox& box : project.cell.boxes) {
        if (const auto pose = inBase(box)) {
            result.around.obstacles.push_back({box.name, *pose, box.size});
        }
    }
    return result;
}

}  // namespace tiller
