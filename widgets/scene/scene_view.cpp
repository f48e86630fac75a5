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
#include <utility>

#include "robot/kinematics/arm_kinematics.h"
#include "robot/kinematics/speed_bounds.h"
#include "widgets/common/format.h"
#include "widgets/common/joint_name.h"
#include "widgets/common/theme.h"
#include "widgets/scene/arm_shape.h"
#include "widgets/scene/scene_keys.h"
#include "widgets/scene/scene_painter.h"

namespace tiller {

namespace {

constexpr int kFrameMs = 16;  // 60 a second at most
constexpr double kTraceSeconds = 8;
constexpr double kTraceStep = 5e-4;   // [m]
constexpr double kStillAngle = 2e-5;  // [rad]: less cannot be seen
constexpr int kGhostPathPoints = 32;
constexpr double kOrbitPerPixel = 0.008;  // [rad]
constexpr double kKeysAt = 8;             // from the corner [px]
constexpr double kFitShare = 0.07;        // of the picture, left free around everything when it is made anew
constexpr double kLeastShare = 0.03;      // and before it moves by itself
constexpr double kToolAxes = 0.095;       // length of the tool's axes, per 0.85 m of reach [m]
constexpr double kFrameAxes = 0.07;
constexpr double kMark = 5;  // half the size of a mark [px]

}  // namespace

SceneView::SceneView(QWidget* parent)
    : QWidget(parent), model_(&robotModel(RobotModelId::UR5e)), keys_(new SceneKeys(this)) {
    setObjectName(QStringLiteral("scene"));
    setAccessibleName(tr("View of the arm"));
    setAccessibleDescription(
        tr("Drag or use the arrow keys to look from another side, with Shift or the right button to move the "
           "picture, the wheel or plus and minus to come nearer, double click or Home for the first view. "
           "Nothing here moves the robot."));
    setFocusPolicy(Qt::StrongFocus);
    camera_.reset(uprightHeight(*model_));
    connect(keys_, &SceneKeys::lookWanted, this, &SceneView::lookFrom);
    connect(keys_, &SceneKeys::fitWanted, this, &SceneView::fitAll);
    placeKeys();
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
    beforeGhost_.reset();
    keptInSight_ = fitWanted_ = true;
    trace_.clear();
    updateGhost();
    changed();
}

void SceneView::setJoints(const JointPositions& q) {
    if (!q.allFinite() || (haveJoints_ && (q.values - q_.values).cwiseAbs().maxCoeff() < kStillAngle)) {
        return;
    }
    q_ = q;
    if (!haveJoints_) {
        haveJoints_ = fitWanted_ = true;
        frame(size());
    }
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
    if (ghost && !ghost_) {
        beforeGhost_ = camera_;
    } else if (!ghost && beforeGhost_) {
        // A look at a target is over: the picture is as it was, unless the operator has changed it.
        camera_.standLike(*beforeGhost_);
        beforeGhost_.reset();
    }
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
            const double distance = ghost_->linear ? kinematics::lineLength(from, to) : largest;
            const double seconds = kinematics::moveDuration(distance, ghost_->speed, ghost_->acceleration) /
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

std::vector<Camera::Ball> SceneView::inSight() const {
    std::vector<Camera::Ball> balls;
    const auto add = [&](const JointPositions& q) {
        for (const ArmPart& part : armParts(*model_, q)) {
            balls.push_back({part.from, part.radius});
            balls.push_back({part.to, part.radius});
        }
    };
    const double reach = model_->reach;
    if (haveJoints_) {
        add(q_);
        balls.push_back(
            {kinematics::forwardTcp(model_->dh, q_, tcpOffset_).position, kToolAxes * reach / 0.85});
    } else {
        add(JointPositions(0, -std::numbers::pi / 2, 0, -std::numbers::pi / 2, 0, 0));  // upright
    }
    if (ghost_ && ghost_->reachable && haveJoints_) {
        add(ghost_->q);
        for (const Eigen::Vector3d& place : ghostPath_) {
            balls.push_back({place, 0});
        }
    }
    // What was taught for another robot may be far away: the arm must not become a dot for it.
    const auto addPlace = [&](const Eigen::Vector3d& place, double radius) {
        if (place.norm() < 2 * reach) {
            balls.push_back({place, radius});
        }
    };
    for (const WaypointMark& waypoint : waypoints_) {
        addPlace(waypoint.position, 0);
    }
    for (const FrameMark& frame : frames_) {
        addPlace(frame.T_base_frame.position, kFrameAxes * reach / 0.85);
    }
    return balls;
}

QMarginsF SceneView::margins(const QSizeF& size, double share) const {
    const double side = share * size.width();
    const double edge = share * size.height();
    const double keys = keys_->isHidden() ? 0 : kKeysAt + keys_->sizeHint().height();
    // In a small picture the arm comes first.
    const double below = std::min(coveredBelow_, size.height() / 4);
    return {side, keys + edge, side, below + edge};
}

void SceneView::setCoveredBelow(double height) {
    if (height != coveredBelow_) {
        coveredBelow_ = height;
        changed();
    }
}

void SceneView::frame(const QSizeF& size) {
    const bool otherSize = size != camera_.viewport();
    camera_.setViewport(size);
    if (!keptInSight_) {
        return;
    }
    if (fitWanted_ || otherSize) {
        fitWanted_ = false;
        camera_.fit(inSight(), margins(size, kFitShare));
    } else {
        camera_.contain(inSight(), margins(size, kLeastShare));
    }
}

void SceneView::placeKeys() {
    keys_->move(static_cast<int>(kKeysAt), static_cast<int>(kKeysAt));
    // In a very small picture the commands are left.
    keys_->setVisible(keys_->sizeHint().width() + 2 * kKeysAt <= width());
}

QString SceneView::hiddenText() const {
    return hiddenLabels_ == 0   ? QString()
           : hiddenLabels_ == 1 ? tr("1 name hidden: come nearer")
                                : tr("%n names hidden: come nearer", nullptr, hiddenLabels_);
}

void SceneView::drawNames(ScenePainter& scene, const QSizeF& size, const QRectF& arrowName) {
    struct Name {
        QPointF at;
        QString text;
        bool selected;
    };
    std::vector<Name> names;
    const QRectF picture(QPointF(0, 0), size);
    const auto add = [&](const Eigen::Vector3d& place, const QString& text, bool selected) {
        const auto at = camera_.project(place);
        const bool seen = at.visible() && picture.contains(at.point);
        if (seen) {
            names.push_back({at.point, text, selected});
        }
        return seen;
    };
    LabelPlacer placer(picture.adjusted(4, 4, -4, -4));
    placer.block(arrowName);
    if (!keys_->isHidden()) {
        placer.block(QRectF(QPointF(kKeysAt, kKeysAt), QSizeF(keys_->sizeHint())));
    }
    for (const WaypointMark& waypoint : waypoints_) {
        if (add(waypoint.position, waypoint.name, waypoint.selected)) {
            const QPointF at = names.back().at;
            scene.marker(at, waypoint.selected);
            placer.block({at.x() - kMark, at.y() - kMark, 2 * kMark, 2 * kMark});
        }
    }
    for (const FrameMark& frame : frames_) {
        add(frame.T_base_frame.position, frame.name, frame.selected);
    }
    // The line that tells how many are left out, wherever it is needed.
    const QRectF line(12, size.height() - 28, size.width() / 2, 22);
    placer.block(line);
    std::stable_partition(names.begin(), names.end(), [](const Name& name) { return name.selected; });
    labels_.clear();
    hiddenLabels_ = 0;
    for (Name& name : names) {
        if (name.text.isEmpty()) {
            continue;
        }
        const QSizeF needed = ScenePainter::nameSize(name.text);
        if (const auto box = placer.place(name.at, needed)) {
            labels_.push_back({name.text, name.at, *box, name.selected});
            scene.name(labels_.back());
        } else {
            ++hiddenLabels_;
        }
    }
    scene.note(line, hiddenText());
}

void SceneView::paintScene(QPainter& painter, const QSizeF& size) {
    const Theme& theme = Theme::current();
    frame(size);
    ScenePainter scene(painter, camera_, theme);
    const double reach = model_->reach;
    scene.ground(reach);
    if (ghost_ && ghost_->reachable && haveJoints_) {
        scene.arm(armParts(*model_, ghost_->q), ArmColors::ghost(theme));
    }
    QRectF arrowName;
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
        scene.axes(T_base_tcp, kToolAxes * reach / 0.85, stale_);
        if (jog_ && !stale_) {
            arrowName = scene.arrow(T_base_tcp.translation(), jog_->direction, reach, theme.axis(jog_->axis),
                                    jog_->label);
        }
    }
    for (const FrameMark& frame : frames_) {
        scene.axes(frame.T_base_frame.transform(), kFrameAxes * reach / 0.85, !frame.selected);
    }
    drawNames(scene, size, arrowName);
    if (stale_ && !staleWord_.isEmpty()) {
        scene.headline(QRectF(QPointF(0, 0), QSizeF(size.width(), size.height() * 0.24)), staleWord_);
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
    placeKeys();
    frame(size());
}

void SceneView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange) {
        placeKeys();  // of another size in another density
    }
}

void SceneView::lookFrom(StandardView from) {
    camera_.look(from);
    fitAll();
    Q_EMIT viewChanged();
}

void SceneView::fitAll() {
    beforeGhost_.reset();
    keptInSight_ = fitWanted_ = true;
    frame(size());
    changed();
}

void SceneView::mousePressEvent(QMouseEvent* event) {
    event->accept();
    if (drag_ != Drag::None) {
        return;
    }
    const bool left = event->button() == Qt::LeftButton;
    if (left || event->button() == Qt::MiddleButton || event->button() == Qt::RightButton) {
        drag_ = left && (event->modifiers() & Qt::ShiftModifier) == 0 ? Drag::Orbit : Drag::Pan;
        dragButton_ = event->button();
        dragFrom_ = event->position();
    }
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
    event->accept();
    if (drag_ == Drag::None) {
        return;
    }
    const QPointF by = event->position() - std::exchange(dragFrom_, event->position());
    if (drag_ == Drag::Orbit) {
        orbitBy(by);
    } else {
        panBy(by);
    }
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
    event->accept();
    if (event->button() == dragButton_) {
        drag_ = Drag::None;
        dragButton_ = Qt::NoButton;
    }
}

void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
    event->accept();
    if (event->button() == Qt::LeftButton) {
        resetView();
    }
}

void SceneView::wheelEvent(QWheelEvent* event) {
    event->accept();
    zoomBy(std::pow(0.88, event->angleDelta().y() / 120.0));
}

void SceneView::keyPressEvent(QKeyEvent* event) {
    constexpr double kStep = 12;  // as many pixels of dragging
    const auto arrow = [&](const QPointF& drag) {
        if ((event->modifiers() & Qt::ShiftModifier) != 0) {
            panBy(drag * 2);
        } else {
            orbitBy(drag);
        }
    };
    switch (event->key()) {
        case Qt::Key_Left:
            arrow({kStep, 0});
            break;
        case Qt::Key_Right:
            arrow({-kStep, 0});
            break;
        case Qt::Key_Up:
            arrow({0, kStep});
            break;
        case Qt::Key_Down:
            arrow({0, -kStep});
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
    beforeGhost_.reset();
    camera_.orbit(-pixels.x() * kOrbitPerPixel, pixels.y() * kOrbitPerPixel);
    changed();
    Q_EMIT viewChanged();
}

// Whoever moves the picture or comes nearer wants to see this place: it stays until the picture is made anew.

void SceneView::panBy(const QPointF& pixels) {
    beforeGhost_.reset();
    keptInSight_ = false;
    camera_.pan(pixels);
    changed();
}

void SceneView::zoomBy(double factor) {
    beforeGhost_.reset();
    keptInSight_ = false;
    camera_.zoom(factor);
    changed();
}

}  // namespace tiller

#include "moc_scene_view.cpp"
