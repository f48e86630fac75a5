// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is solid in the scene: the arm, its tool, its ghost, and the cell around it, as one picture. What has not
// changed since the last picture is not drawn again.

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

/// What an arm and its cell are painted with.
struct ArmColors {
    static BodyColors live(const Theme& theme);
    static BodyColors stale(const Theme& theme);
    static BodyColors ghost(const Theme& theme);
    static BodyColors secondGhost(const Theme& theme);
    static BodyColors replay(const Theme& theme);  ///< as it stood
    static BodyColors border(const Theme& theme);  ///< a plane nothing may pass
};

class SceneBodies {
public:
    SceneBodies();
    ~SceneBodies();

    /// It is kept, and has to stay.
    void setModel(const RobotModel& model);
    /// Nothing: no arm is shown.
    void setArm(const std::optional<JointPositions>& q, bool stale);
    void setGhost(const std::optional<JointPositions>& q);
    /// Beside the first, of another colour.
    void setSecondGhost(const std::optional<JointPositions>& q);
    void setReplay(const std::optional<JointPositions>& q);
    /// Without a radius a thin rod leads to the TCP.
    void setTool(const collision::ToolBody& tool);
    /// Boxes and planes; a floor, which has no name, is not drawn here.
    void setSurroundings(const collision::Surroundings& surroundings);

    /// Brings the picture up to date.
    /// size   of the view [px]
    /// scale  of the screen: pixels for one of the view's
    /// Returns  where the picture is another one than before, in the view's pixels
    QRect update(const Camera& camera, const QSize& size, double scale, const Theme& theme);
    void paint(QPainter& painter) const;
    /// True when a body hides this place, as updated last.
    bool hides(const Camera::Projected& place) const;

private:
    void addArm(const JointPositions& q, const BodyColors& colors);

    const RobotModel* model_ = nullptr;
    ArmMesh arm_;
    Mesh tool_;   ///< in the flange's frame
    Mesh boxes_;  ///< in the base frame, as the next
    Mesh borders_;
    std::optional<JointPositions> q_;
    std::optional<JointPositions> ghost_;
    std::optional<JointPositions> second_;
    std::optional<JointPositions> replay_;
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
