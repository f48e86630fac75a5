// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/scene_bodies.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "robot/kinematics/arm_kinematics.h"

namespace tiller {

namespace {

QColor between(const QColor& a, const QColor& b, double share) {
    const auto channel = [share](int x, int y) { return static_cast<int>(std::lround(x + (y - x) * share)); };
    return {channel(a.red(), b.red()), channel(a.green(), b.green()), channel(a.blue(), b.blue())};
}

constexpr double kGhostOpacity = 0.58;
constexpr double kReplayOpacity = 0.4;

}  // namespace

BodyColors ArmColors::live(const Theme& theme) {
    if (theme.isDark()) {
        return {{QColor(0xA9, 0xB0, 0xB8), QColor(0xC2, 0xC8, 0xCE), QColor(0x4C, 0x92, 0xC8),
                 QColor(0x30, 0x35, 0x3A), QColor(0x80, 0x87, 0x8E), QColor(0x6B, 0x73, 0x7B),
                 QColor(0x70, 0x78, 0x80)},
                1,
                0.35};
    }
    return {{QColor(0xB4, 0xBB, 0xC3), QColor(0xD2, 0xD7, 0xDC), QColor(0x4B, 0x89, 0xB8),
             QColor(0x3C, 0x42, 0x49), QColor(0x8B, 0x93, 0x9B), QColor(0x6E, 0x77, 0x80),
             QColor(0xA8, 0xAE, 0xB5)},
            1,
            0.35};
}

BodyColors ArmColors::stale(const Theme& theme) {
    const auto grey = [&](double share) { return between(theme.panel, theme.secondary, share); };
    return {{grey(0.34), grey(0.24), grey(0.50), grey(0.62), grey(0.42), grey(0.42), grey(0.3)}, 1, 0.1};
}

BodyColors ArmColors::ghost(const Theme& theme) {
    const QColor color = between(theme.panel, theme.moving, 0.85);
    const QColor lid = between(theme.panel, theme.moving, 0.95);
    return {{color, color, lid, lid, color, color, color}, kGhostOpacity, 0.15};
}

BodyColors ArmColors::secondGhost(const Theme& theme) {
    const QColor color = between(theme.panel, theme.axis(1), 0.85);
    BodyColors colors = ghost(theme);
    colors.materials.fill(color);
    return colors;
}

BodyColors ArmColors::replay(const Theme& theme) {
    const QColor color = between(theme.panel, theme.text, 0.55);
    const QColor lid = between(theme.panel, theme.text, 0.8);
    return {{color, color, lid, lid, color, color, color}, kReplayOpacity, 0};
}

BodyColors ArmColors::border(const Theme& theme) {
    BodyColors colors;
    colors.materials.fill(between(theme.panel, theme.operatorNeeded, 0.8));
    colors.opacity = 0.22;
    colors.shine = 0;
    return colors;
}

SceneBodies::SceneBodies() : raster_(std::make_unique<Rasterizer>()) {}

SceneBodies::~SceneBodies() = default;

void SceneBodies::setModel(const RobotModel& model) {
    model_ = &model;
    arm_ = armMesh(model);
    changed_ = true;
}

void SceneBodies::setArm(const std::optional<JointPositions>& q, bool stale) {
    changed_ = changed_ || q != q_ || stale != stale_;
    q_ = q;
    stale_ = stale;
}

void SceneBodies::setGhost(const std::optional<JointPositions>& q) {
    changed_ = changed_ || q != ghost_;
    ghost_ = q;
}

void SceneBodies::setSecondGhost(const std::optional<JointPositions>& q) {
    changed_ = changed_ || q != second_;
    second_ = q;
}

void SceneBodies::setReplay(const std::optional<JointPositions>& q, const RobotModel& model) {
    const RobotModel* other = q && model.id != model_->id ? &model : nullptr;
    changed_ = changed_ || q != replay_ || other != replayModel_;
    replay_ = q;
    if (other != std::exchange(replayModel_, other) && other != nullptr) {
        replayArm_ = armMesh(*other);
    }
}

void SceneBodies::setTool(const collision::ToolBody& tool) {
    constexpr double kThinRod = 0.005;   // [m]
    constexpr double kMinValue = 0.002;  // [m]; a closer TCP is inside the flange
    tool_ = {};
    const double length = tool.tcpOffset.position.norm();
    if (length > kMinValue) {
        Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
        T.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), tool.tcpOffset.position)
                         .toRotationMatrix();
        const double radius = tool.radius > 0 ? tool.radius : kThinRod;
        constexpr int kSegments = 24;
        addLathe(tool_, T, drumOutline(radius, 0, length, std::min(radius, length / 2) * 0.9), kSegments,
                 Material::Tool);
    }
    changed_ = true;
}

void SceneBodies::setSurroundings(const collision::Surroundings& surroundings) {
    boxes_ = {};
    borders_ = {};
    for (const collision::Obstacle& obstacle : surroundings.obstacles) {
        addBox(boxes_, obstacle.pose.transform(), obstacle.size, Material::Cell);
    }
    for (const collision::Border& border : surroundings.borders) {
        if (!border.name.isEmpty()) {
            constexpr double kEdge = 1.2;  // displayed size of an unlimited plane [m]
            constexpr double kThickness = 0.002;
            addBox(borders_, border.pose.transform(), {kEdge, kEdge, kThickness}, Material::Cell);
        }
    }
    changed_ = true;
}

void SceneBodies::addArm(const JointPositions& q, const BodyColors& colors) {
    const auto frames = kinematics::linkFrames(model_->dh, q);
    for (std::size_t i = 0; i < arm_.size(); ++i) {
        raster_->add(arm_[i], frames[i], colors);
    }
    raster_->add(tool_, frames.back(), colors);
}

void SceneBodies::addReplay(const BodyColors& colors) {
    if (replayModel_ == nullptr) {
        addArm(*replay_, colors);
        return;
    }
    const auto frames = kinematics::linkFrames(replayModel_->dh, *replay_);
    for (std::size_t i = 0; i < replayArm_.size(); ++i) {
        raster_->add(replayArm_[i], frames[i], colors);
    }
}

QRect SceneBodies::update(const Camera& camera, const QSize& size, double scale, const Theme& theme) {
    const Camera::Eye eye = camera.eye();
    const bool isOutdated = size != size_ || scale != scale_ || !(eye == eye_) || scheme_ != theme.scheme;
    if (!isOutdated && !changed_) {
        return {};
    }
    changed_ = false;
    size_ = size;
    scale_ = scale;
    eye_ = eye;
    scheme_ = theme.scheme;
    const QSize pixels(static_cast<int>(std::ceil(size.width() * scale)),
                       static_cast<int>(std::ceil(size.height() * scale)));
    raster_->begin(pixels, camera, scale);
    const BodyColors own = ArmColors::live(theme);
    raster_->add(boxes_, Eigen::Isometry3d::Identity(), own);
    raster_->add(borders_, Eigen::Isometry3d::Identity(), ArmColors::border(theme));
    if (q_) {
        addArm(*q_, stale_ ? ArmColors::stale(theme) : ArmColors::live(theme));
    }
    if (ghost_) {
        addArm(*ghost_, ArmColors::ghost(theme));
    }
    if (second_) {
        addArm(*second_, ArmColors::secondGhost(theme));
    }
    if (replay_) {
        addReplay(ArmColors::replay(theme));
    }
    const QRect before = std::exchange(covered_, raster_->covered());
    picture_ = &raster_->render(before | covered_);
    if (isOutdated) {
        return {QPoint(0, 0), size};
    }
    const QRectF part(before | covered_);
    return QRectF(part.topLeft() / scale, part.size() / scale).toAlignedRect();
}

void SceneBodies::paint(QPainter& painter) const {
    if (picture_ != nullptr && !covered_.isEmpty()) {
        const QRectF part(covered_);
        painter.drawImage(QRectF(part.topLeft() / scale_, part.size() / scale_), *picture_, part);
    }
}

bool SceneBodies::hides(const Camera::Projected& place) const {
    return raster_->hides(place.point, place.depth);
}

}  // namespace tiller
