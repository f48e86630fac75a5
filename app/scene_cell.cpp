// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene_cell.h"

#include <algorithm>

#include "robot/simulator/simulator.h"
#include "robot/station/document/cell_surroundings.h"
#include "robot/station/document/project_document.h"
#include "widgets/scene/scene_view.h"

namespace tiller::app {

void followCell(SceneView& view, const ProjectDocument& document) {
    const auto follow = [&view, &document] { view.setSurroundings(surroundingsOf(document.project())); };
    for (const auto change : {&ProjectDocument::cellChanged, &ProjectDocument::framesChanged,
                              &ProjectDocument::toolingChanged, &ProjectDocument::projectReplaced}) {
        QObject::connect(&document, change, &view, follow);
    }
    follow();
}

int simulateCell(simulator::Simulator& robot, const ProjectDocument& document) {
    using Environment = simulator::arm::Environment;
    const collision::Surroundings around = surroundingsOf(document.project()).around;
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
