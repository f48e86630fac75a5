// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The solid objects of the scene as one image: the arm, its tool, its ghost, and the cell. Only changes since
// the last image are rendered.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "robot/collision/surroundings.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"
#include "widgets/common/theme.h"
#include "widgets/scene/arm_mesh.h"
#include "widgets/scene/camera.h"
#include "widgets/scene/rasterizer.h"

class QPainter;

namespace tiller {

/// Colours of the arm, of its ghosts and of the cell.
struct ArmColors {
    static BodyColors live(const Theme& theme);
    static BodyColors stale(const Theme& theme);
    static BodyColors ghost(const Theme& theme);
    static BodyColors secondGhost(const Theme& theme);
    static BodyColors replay(const Theme& theme);  ///< a past position of the arm
    static BodyColors border(const Theme& theme);  ///< a boundary plane
};

class SceneBodies {
public:
    SceneBodies();
    ~SceneBodies();

    /// model  must outlive the object
    void setModel(const RobotModel& model);
    /// Sets the joint positions of the arm. Empty: no arm is shown.
    void setArm(const std::optional<JointPositions>& q, bool stale);
    void setGhost(const std::optional<JointPositions>& q);
    /// Sets a second ghost, in a different colour.
    void setSecondGhost(const std::optional<JointPositions>& q);
    /// model  the model of the replayed arm, which must outlive the object; drawn without a tool if it
    ///        differs from the model of the arm
    void setReplay(const std::optional<JointPositions>& q, const RobotModel& model);
    /// If the tool has no radius, a thin rod connects flange and TCP.
    void setTool(const collision::ToolBody& tool);
    /// Sets the boxes and planes. The floor, which has no name, is not drawn.
    void setSurroundings(const collision::Surroundings& surroundings);

    /// Updates the image.
    /// size     size of the view [px]
    /// scale    device pixels per pixel of the view
    /// Returns  the changed part [px of the view]
    QRect update(const Camera& camera, const QSize& size, double scale, const Theme& theme);
    void paint(QPainter& painter) const;
    /// True if a body hides this position in the image of the last update().
    bool hides(const Camera::Projected& place) const;

private:
    void addArm(const JointPositions& q, const BodyColors& colors);
    void addReplay(const BodyColors& colors);

    const RobotModel* model_ = nullptr;
    ArmMesh arm_;
    Mesh tool_;   ///< in the flange frame
    Mesh boxes_;  ///< in the base frame, like borders_
    Mesh borders_;
    std::optional<JointPositions> q_;
    std::optional<JointPositions> ghost_;
    std::optional<JointPositions> second_;
    std::optional<JointPositions> replay_;
    const RobotModel* replayModel_ = nullptr;  ///< set if it differs from model_
    ArmMesh replayArm_;                        ///< mesh of replayModel_
    bool stale_ = false;
    bool changed_ = true;
    std::unique_ptr<Rasterizer> raster_;
    Camera::Eye eye_;
    QSize size_;
    double scale_ = 1;
    std::optional<ColorScheme> scheme_;
    QRect covered_;
    const QImage* picture_ = nullptr;
};

}  // namespace tiller
