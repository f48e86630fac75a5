// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/scene_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "robot/kinematics/arm_kinematics.h"
#include "widgets/common/format.h"
#include "widgets/common/joint_name.h"
#include "widgets/common/theme.h"
#include "widgets/scene/arm_shape.h"
#include "widgets/scene/scene_painter.h"

namespace tiller {

namespace {

constexpr int kFrameMs = 16;  // 60 a second at most
constexpr double kTraceSeconds = 8;
constexpr double kTraceStep = 5e-4;   // [m]
constexpr double kStillAngle = 2e-5;  // [rad]: less cannot be seen
constexpr int kGhostPathPoints = 32;
constexpr double kOrbitPerPixel = 0.008;  // [rad]

/// How long a motion over this distance takes, from rest to rest.
double trapezoidSeconds(double distance, double speed, double acceleration) {
    if (speed <= 0 || acceleration <= 0 || distance <= 0) {
        return 0;
    }
    const double ramps = speed * speed / acceleration;
    return distance < ramps ? 2 * std::sqrt(distance / acceleration)
                            : distance / speed + speed / acceleration;
}

}  // namespace

SceneView::SceneView(QWidget* parent) : QWidget(parent), model_(&robotModel(RobotModelId::UR5e)) {
    setObjectName(QStringLiteral("scene"));
    setAccessibleName(tr("View of the arm"));
    setAccessibleDescription(tr(
        "Drag or use the arrow keys to look from another side, the wheel or plus and minus to come nearer, "
        "double click or Home for the first view. Nothing here moves the robot."));
    setFocusPolicy(Qt::StrongFocus);
    camera_.reset(uprightHeight(*model_));
    frameTimer_.setSingleShot(true);
    frameTimer_.setTimerType(Qt::PreciseTimer);
    connect(&frameTimer_, &QTimer::timeout, this, [this] { update(); });
}

SceneView::~SceneView() = default;

void SceneView::changed() {
    if (frameTimer_.isActive()) {
        return;
    }
    const std::int64_t since = (SteadyClock::shared().nowNs() - lastPaintNs_) / kNsPerMs;
    frameTimer_.start(static_cast<int>(std::clamp<std::int64_t>(kFrameMs - since, 0, kFrameMs)));
}

void SceneView::setModel(RobotModelId model) {
    if (model_->id == model) {
        return;
    }
    model_ = &robotModel(model);
    camera_.reset(uprightHeight(*model_));
    trace_.clear();
    updateGhost();
    changed();
}

void SceneView::setJoints(const JointPositions& q) {
    if (!q.allFinite() || (haveJoints_ && (q.values - q_.values).cwiseAbs().maxCoeff() < kStillAngle)) {
        return;
    }
    q_ = q;
    haveJoints_ = true;
    updateGhost();
    changed();
}

void SceneView::setTcpOffset(const Pose& offset) {
    if (!(offset == tcpOffset_) && offset.allFinite()) {
        tcpOffset_ = offset;
        trace_.clear();
        updateGhost();
        changed();
    }
}

void SceneView::setGhost(const std::optional<Ghost>& ghost) {
    ghost_ = ghost;
    updateGhost();
    changed();
}

void SceneView::setWaypoints(const std::vector<WaypointMark>& waypoints) {
    waypoints_ = waypoints;
    changed();
}

void SceneView::setFrames(const std::vector<FrameMark>& frames) {
    frames_ = frames;
    changed();
}

void SceneView::setJogDirection(const std::optional<SceneJog>& jog) {
    jog_ = jog;
    changed();
}

void SceneView::setStale(bool stale, const QString& word) {
    if (stale != stale_ || word != staleWord_) {
        stale_ = stale;
        staleWord_ = word;
        changed();
    }
}

void SceneView::setSpeedFraction(double fraction) {
    if (fraction != speedFraction_) {
        speedFraction_ = fraction;
        updateGhost();
    }
}

void SceneView::setState(const SessionState& state) {
    if (!state.hasData()) {
        const bool lost = state.link == LinkState::Lost;
        setStale(true, lost ? tr("NO DATA") : tr("Not connected"));
        return;
    }
    setModel(state.model);
    setTcpOffset(state.tcpOffset);
    setSpeedFraction(state.speedFraction);
    setJoints(state.q);
    setStale(state.link != LinkState::Live);
    extendTrace(state.robotTime, kinematics::forwardTcp(model_->dh, q_, tcpOffset_).position);
}

void SceneView::extendTrace(double now, const Eigen::Vector3d& tcp) {
    if (!trace_.empty() && now < trace_.back().time) {
        trace_.clear();  // the controller began its time anew
    }
    if (trace_.empty() || (trace_.back().position - tcp).norm() > kTraceStep) {
        trace_.push_back({now, tcp});
    }
    bool dropped = false;
    while (trace_.size() > 1 && trace_.front().time < now - kTraceSeconds) {
        trace_.pop_front();
        dropped = true;
    }
    if (dropped) {
        changed();
    }
}

void SceneView::updateGhost() {
    QString text;
    ghostPath_.clear();
    if (ghost_) {
        const Vector6 turn = ghost_->q.values - q_.values;
        const Pose from = kinematics::forwardTcp(model_->dh, q_, tcpOffset_);
        const Pose to = kinematics::forwardTcp(model_->dh, ghost_->q, tcpOffset_);
        if (!ghost_->reachable) {
            text = tr("ghost “%1” · out of reach").arg(ghost_->name);
        } else {
            int joint = 0;
            const double largest = turn.cwiseAbs().maxCoeff(&joint);
            const double distance = ghost_->linear ? (to.position - from.position).norm() : largest;
            const double seconds = trapezoidSeconds(distance, ghost_->speed, ghost_->acceleration) /
                                   std::max(0.02, speedFraction_);
            text = tr("ghost “%1” · reachable · largest turn %2 %3 · %4 s at %5")
                       .arg(ghost_->name, jointName(joint), format::degrees(largest, 0),
                            format::number(seconds, 1), format::percent(speedFraction_));
        }
        const int last = ghost_->linear ? 1 : kGhostPathPoints;
        for (int i = 0; i <= last && haveJoints_ && ghost_->reachable; ++i) {
            const double share = static_cast<double>(i) / last;
            ghostPath_.push_back(
                ghost_->linear
                    ? Eigen::Vector3d(from.position + share * (to.position - from.position))
                    : kinematics::forwardTcp(model_->dh, JointPositions(q_.values + share * turn), tcpOffset_)
                          .position);
        }
    }
    if (text != ghostText_) {
        ghostText_ = text;
        Q_EMIT ghostTextChanged(text);
    }
}

QString SceneView::ghostText() const {
    return ghostText_;
}

void SceneView::paintScene(QPainter& painter, const QSizeF& size) {
    const Theme& theme = Theme::current();
    camera_.setViewport(size);
    ScenePainter scene(painter, camera_, theme);
    const double reach = model_->reach;
    scene.ground(reach);
    if (ghost_ && ghost_->reachable && haveJoints_) {
        scene.arm(armParts(*model_, ghost_->q), ArmColors::ghost(theme));
    }
    if (haveJoints_) {
        scene.arm(armParts(*model_, q_), stale_ ? ArmColors::stale(theme) : ArmColors::live(theme));
        if (trace_.size() > 1) {
            std::vector<Eigen::Vector3d> points;
            points.reserve(trace_.size());
            std::transform(trace_.begin(), trace_.end(), std::back_inserter(points),
                           [](const TracePoint& p) { return p.position; });
            scene.path(points, stale_ ? theme.border : theme.moving, 1.4, false);
        }
        scene.path(ghostPath_, theme.moving, 2.4, true);
        const Eigen::Isometry3d T_base_tcp = kinematics::forwardTcp(model_->dh, q_, tcpOffset_).transform();
        scene.axes(T_base_tcp, 0.095 * reach / 0.85, stale_);
        if (jog_ && !stale_) {
            scene.arrow(T_base_tcp.translation(), jog_->direction, reach, theme.axis(jog_->axis),
                        jog_->label);
        }
    }
    for (const FrameMark& frame : frames_) {
        scene.axes(frame.T_base_frame.transform(), 0.07 * reach / 0.85, !frame.selected);
        scene.caption(frame.T_base_frame.position, frame.name, frame.selected);
    }
    for (const WaypointMark& waypoint : waypoints_) {
        scene.marker(waypoint.position, waypoint.name, waypoint.selected);
    }
    if (stale_ && !staleWord_.isEmpty()) {
        painter.setFont(textFont(26, QFont::Bold));
        painter.setPen(theme.secondary);
        painter.drawText(QRectF(QPointF(0, 0), QSizeF(size.width(), size.height() * 0.24)), Qt::AlignCenter,
                         staleWord_);
    }
}

void SceneView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintScene(painter, size());
    if (hasFocus() && focusByKey_) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setPen(QPen(Theme::current().moving, 1, Qt::DotLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(2, 2, -3, -3));
    }
    lastPaintNs_ = SteadyClock::shared().nowNs();
}

void SceneView::focusInEvent(QFocusEvent* event) {
    focusByKey_ = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
    QWidget::focusInEvent(event);
}

void SceneView::resizeEvent(QResizeEvent*) {
    camera_.setViewport(size());
}

void SceneView::resetView() {
    camera_.reset(uprightHeight(*model_));
    changed();
    Q_EMIT viewChanged();
}

void SceneView::mousePressEvent(QMouseEvent* event) {
    event->accept();
    if (event->button() == Qt::LeftButton) {
        dragging_ = true;
        dragFrom_ = event->position();
    }
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
    event->accept();
    if (dragging_) {
        orbitBy(event->position() - dragFrom_);
        dragFrom_ = event->position();
    }
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
    event->accept();
    if (event->button() == Qt::LeftButton) {
        dragging_ = false;
    }
}

void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
    event->accept();
    resetView();
}

void SceneView::wheelEvent(QWheelEvent* event) {
    event->accept();
    zoomBy(std::pow(0.88, event->angleDelta().y() / 120.0));
}

void SceneView::keyPressEvent(QKeyEvent* event) {
    constexpr double kStep = 12;  // as many pixels of dragging
    switch (event->key()) {
        case Qt::Key_Left:
            orbitBy({kStep, 0});
            break;
        case Qt::Key_Right:
            orbitBy({-kStep, 0});
            break;
        case Qt::Key_Up:
            orbitBy({0, kStep});
            break;
        case Qt::Key_Down:
            orbitBy({0, -kStep});
            break;
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            zoomBy(0.88);
            break;
        case Qt::Key_Minus:
            zoomBy(1 / 0.88);
            break;
        case Qt::Key_Home:
            resetView();
            break;
        default:
            event->ignore();  // Space and Esc stop the robot: never taken here
            return;
    }
    event->accept();
}

void SceneView::orbitBy(const QPointF& pixels) {
    camera_.orbit(-pixels.x() * kOrbitPerPixel, pixels.y() * kOrbitPerPixel);
    changed();
    Q_EMIT viewChanged();
}

void SceneView::zoomBy(double factor) {
    camera_.zoom(factor);
    changed();
}

}  // namespace tiller
