// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene_cell.h"

#include <algorithm>

#include "robot/simulator/simulator.h"
#include "robot/station/document/project_document.h"
#include "robot/station/link/robot_session.h"
#include "widgets/scene/scene_view.h"

namespace tiller::app {

namespace {

/// In the base frame; what is given in a frame that is not in the project is nowhere.
collision::Surroundings surroundingsOf(const project::CellGeometry& cell, const project::FrameList& frames) {
    collision::Surroundings result;
    const auto inBase = [&](const QUuid& frame, const Pose& pose) -> std::optional<Pose> {
        const std::optional<Pose> T_base_frame = frames.pose(frame);
        return T_base_frame ? std::optional(Pose(T_base_frame->transform() * pose.transform()))
                            : std::nullopt;
    };
    if (cell.floor) {
        result.borders.push_back({{}, Pose(0, 0, *cell.floor, 0, 0, 0)});
    }
    for (const project::CellPlane& plane : cell.planes) {
        const auto pose = inBase(plane.frame, plane.pose);
        if (pose && plane.enabled) {
            result.borders.push_back({plane.name, *pose});
        }
    }
    for (const project::CellBox& box : cell.boxes) {
        const auto pose = inBase(box.frame, box.pose);
        if (pose && box.enabled) {
            result.obstacles.push_back({box.name, *pose, box.size});
        }
    }
    return result;
}

double toolRadius(const project::Tooling& tooling) {
    for (const project::Tool& tool : tooling.tools) {
        if (tool.id == tooling.activeTool) {
            return tool.radius;
        }
    }
    return 0;
}

}  // namespace

void followCell(SceneView& view, RobotSession& session, const ProjectDocument& document) {
    const auto follow = [&view, &session, &document] {
        const collision::CellSurroundings cell{surroundingsOf(document.cell(), document.frames()),
                                               toolRadius(document.tooling()),
                                               document.cell().safetyDistance};
        view.setSurroundings(cell);
        session.setSurroundings(cell);
    };
    for (const auto change : {&ProjectDocument::cellChanged, &ProjectDocument::framesChanged,
                              &ProjectDocument::toolingChanged, &ProjectDocument::projectReplaced}) {
        QObject::connect(&document, change, &view, follow);
    }
    follow();
}

int simulateCell(simulator::Simulator& robot, const ProjectDocument& document) {
    using Environment = simulator::arm::Environment;
    const collision::Surroundings around = surroundingsOf(document.cell(), document.frames());
    robot.changeWorld([around](Environment& world) {
        world.clearSurfaces();
        for (const collision::Border& border : around.borders) {
            const Eigen::Isometry3d T = border.pose.transform();
            world.addPlane({.point = T.translation(), .normal = T.linear().col(2)});
        }
        for (const collision::Obstacle& obstacle : around.obstacles) {
            world.addBox({.T_base_box = obstacle.pose, .size = obstacle.size});
        }
    });
    const auto over = [](std::size_t count, int room) { return std::max(0, static_cast<int>(count) - room); };
    return over(around.borders.size(), Environment::kMaxPlanes) +
           over(around.obstacles.size(), Environment::kMaxBoxes);
}

}  // namespace tiller::app
