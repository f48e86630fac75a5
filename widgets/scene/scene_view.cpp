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

#include "robot/collision/arm_body.h"
#include "robot/kinematics/arm_kinematics.h"
#include "robot/kinematics/speed_bounds.h"
#include "robot/station/text/format.h"
#include "robot/station/text/joint_name.h"
#include "robot/station/text/move_words.h"
#include "widgets/common/theme.h"
#include "widgets/scene/scene_bodies.h"
#include "widgets/scene/scene_keys.h"
#include "widgets/scene/scene_painter.h"

namespace tiller {

namespace {

constexpr int kFrameMs = 16;          // at most 60 frames per second
constexpr double kStillAngle = 2e-5;  // [rad]; smaller changes are not visible
constexpr int kExamineMs = 150;
constexpr double kGhostApart = 0.003;     // minimum difference of a joint for drawing a ghost [rad]
constexpr double kOrbitPerPixel = 0.008;  // [rad]
constexpr double kKeysAt = 8;             // distance of the buttons from the corner [px]
constexpr double kFitShare = 0.07;        // margin when the view is fitted, as a fraction of the image
constexpr double kMinShare = 0.03;        // margin below which the view moves automatically
constexpr double kToolAxes = 0.095;       // length of the tool axes, per 0.85 m of reach [m]
constexpr double kFrameAxes = 0.07;
constexpr double kMark = 5;      // half the size of a mark [px]
constexpr double kSeenMove = 1;  // smaller motions of the arm are not redrawn [device px]
constexpr int kSoonMs = 4;       // [ms]; if less time remains, repaint immediately

}  // namespace

SceneView::SceneView(QWidget* parent)
    : QWidget(parent)
    , model_(robotModel(RobotModelId::UR5e))
    , bodies_(std::make_unique<SceneBodies>())
    , keys_(new SceneKeys(this)) {
    bodies_->setModel(model_);
    setObjectName(QStringLiteral("scene"));
    setAccessibleName(tr("Arm view"));
    setAccessibleDescription(
        tr("Drag or use the arrow keys to rotate the view; hold Shift or the right button to pan. Zoom with "
           "the wheel or with plus and minus. Double-click or press Home for the default view. The robot "
           "does not move."));
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);  // the background covers the whole widget
    camera_.reset(collision::uprightHeight(model_));
    connect(keys_, &SceneKeys::lookWanted, this, &SceneView::lookFrom);
    connect(keys_, &SceneKeys::fitWanted, this, &SceneView::fitAll);
    placeKeys();
    frameTimer_.setSingleShot(true);
    frameTimer_.setTimerType(Qt::PreciseTimer);
    connect(&frameTimer_, &QTimer::timeout, this, [this] { update(); });
    examineTimer_.setSingleShot(true);
    examineTimer_.setInterval(kExamineMs);
    connect(&examineTimer_, &QTimer::timeout, this, [this] {
        updateGhost();
        changed();
    });
}

SceneView::~SceneView() = default;

void SceneView::changed() {
    if (frameTimer_.isActive()) {
        return;
    }
    const std::int64_t since = (SteadyClock::shared().nowNs() - lastPaintNs_) / kNsPerMs;
    const auto wait = static_cast<int>(std::clamp<std::int64_t>(kFrameMs - since, 0, kFrameMs));
    // Repaint in a separate event, so that pending input events are processed first.
    frameTimer_.start(wait <= kSoonMs ? 0 : wait);
}

bool SceneView::armHasMoved() const {
    if (q_ == drawnAt_) {
        return false;
    }
    const auto before = kinematics::linkFrames(model_.dh, drawnAt_);
    const auto now = kinematics::linkFrames(model_.dh, q_);
    const double limit = kSeenMove / devicePixelRatioF();
    const auto isSeen = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
        const QPointF by = camera_.project(to).point - camera_.project(from).point;
        return std::hypot(by.x(), by.y()) >= limit;
    };
    // Compare the tips of the axes of each frame. They extend beyond the housing, so a rotation about the
    // axis of the housing is also detected.
    const double beside = kToolAxes * model_.reach / 0.85;
    const auto hasMoved = [&](const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
        if (isSeen(from.translation(), to.translation())) {
            return true;
        }
        for (int axis = 0; axis < 3; ++axis) {
            const Eigen::Vector3d tip = beside * Eigen::Vector3d::Unit(axis);
            if (isSeen(from * tip, to * tip)) {
                return true;
            }
        }
        return false;
    };
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (hasMoved(before[i], now[i])) {
            return true;
        }
    }
    const Eigen::Isometry3d tool = tcpOffset_.transform();
    return hasMoved(before.back() * tool, now.back() * tool);
}

void SceneView::setModel(const RobotModel& model) {
    const bool another = model_.id != model.id;
    if (!another && model_.dh == model.dh) {
        return;
    }
    model_ = model;
    bodies_->setModel(model_);
    rebuildCheck();
    if (another) {
        camera_.reset(collision::uprightHeight(model_));
        beforeGhost_.reset();
        keptInSight_ = fitWanted_ = true;
    }
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
        updateGhost();
        changed();
        return;
    }
    if (ghost_ && !examineTimer_.isActive()) {
        examineTimer_.start();
    }
    if (armHasMoved()) {
        changed();
    }
}

void SceneView::setTcpOffset(const Pose& offset) {
    if (!(offset == tcpOffset_) && offset.allFinite()) {
        tcpOffset_ = offset;
        trace_.clear();
        rebuildCheck();
        updateGhost();
        changed();
    }
}

void SceneView::setGhost(const std::optional<Ghost>& ghost) {
    if (ghost && !ghost_) {
        beforeGhost_ = camera_;
    } else if (!ghost && beforeGhost_) {
        // When the ghost disappears, restore the previous view unless the user has changed the view.
        camera_.standLike(*beforeGhost_);
        beforeGhost_.reset();
    }
    ghost_ = ghost;
    updateGhost();
    changed();
}

void SceneView::setSecondGhost(const std::optional<Ghost>& ghost) {
    if (ghost || secondGhost_) {
        secondGhost_ = ghost;
        changed();
    }
}

void SceneView::setReplay(const std::optional<ReplayMark>& replay) {
    if (replay != replay_) {
        replay_ = replay;
        changed();
    }
}

const RobotModel& SceneView::replayModel() const {
    const bool isOther = replay_ && replay_->model && *replay_->model != model_.id;
    return isOther ? robotModel(*replay_->model) : model_;
}

QString SceneView::replayHeadline() const {
    if (!replay_) {
        return {};
    }
    return replay_->q.allFinite() ? tr("REPLAY") : haveJoints_ && !stale_ ? tr("LIVE ARM") : QString();
}

void SceneView::setWaypoints(const std::vector<WaypointMark>& waypoints) {
    waypoints_ = waypoints;
    changed();
}

void SceneView::setFrames(const std::vector<FrameMark>& frames) {
    frames_ = frames;
    changed();
}

void SceneView::setSurroundings(const collision::CellSurroundings& cell) {
    cell_ = cell;
    bodies_->setSurroundings(cell.around);
    groundScheme_.reset();
    rebuildCheck();
    updateGhost();
    changed();
}

void SceneView::rebuildCheck() {
    bodies_->setTool({tcpOffset_, cell_.toolRadius});
    check_.reset();
}

std::optional<double> SceneView::floorHeight() const {
    for (const collision::Border& border : cell_.around.borders) {
        if (border.name.isEmpty()) {
            return border.pose.position.z();
        }
    }
    return std::nullopt;
}

void SceneView::setPaths(const std::vector<PathMark>& paths) {
    paths_ = paths;
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
    if (model_.id != state.model || model_.dh != state.dh) {
        setModel(state.arm());
    }
    setTcpOffset(state.tcpOffset);
    setSpeedFraction(state.speedFraction);
    setJoints(state.q);
    setStale(state.link != LinkState::Live);
    // New points are drawn together with the arm. Repaint only if the start of the trace has changed.
    const double began = trace_.begins();
    trace_.extend(state.robotTime, kinematics::forwardTcp(model_.dh, q_, tcpOffset_).position);
    if (trace_.begins() != began) {
        changed();
    }
}

void SceneView::updateGhost() {
    examineTimer_.stop();
    report_.reset();
    if (ghost_ && ghost_->reachable && haveJoints_) {
        if (!check_) {
            check_.emplace(model_, collision::ToolBody{tcpOffset_, cell_.toolRadius}, cell_.around,
                           cell_.safetyDistance);
        }
        report_ = collision::examineMove(model_, *check_, tcpOffset_,
                                         {q_, ghost_->q, ghost_->linear, ghost_->speed, ghost_->acceleration},
                                         speedFraction_);
    }
    const QString limit = report_ && report_->limit ? limitText(*report_->limit, cell_.around) : QString();
    if (limit != limitText_) {
        limitText_ = limit;
        Q_EMIT moveLimitChanged(limit);
    }
    const QString text = ghostValues();
    if (text != ghostText_) {
        ghostText_ = text;
        Q_EMIT ghostTextChanged(text);
    }
}

QString SceneView::ghostValues() const {
    if (!ghost_) {
        return {};
    }
    if (!ghost_->reachable) {
        return ghost_->otherModel ? tr("ghost “%1” · taught with a different robot model").arg(ghost_->name)
                                  : tr("ghost “%1” · out of reach").arg(ghost_->name);
    }
    if (!report_) {
        return tr("ghost “%1” · reachable").arg(ghost_->name);
    }
    const QString turn = format::degrees(std::abs(report_->largestTurn), 0);
    const QString seconds = format::number(report_->duration, 1);
    if (!limitText_.isEmpty()) {
        return tr("ghost “%1” · %2 · largest rotation %3 %4 · %5 s at %6")
            .arg(ghost_->name, limitText_, jointName(report_->largestTurnJoint), turn, seconds,
                 format::percent(speedFraction_));
    }
    return tr("ghost “%1” · reachable · largest rotation %2 %3 · %4 s at %5")
        .arg(ghost_->name, jointName(report_->largestTurnJoint), turn, seconds,
             format::percent(speedFraction_));
}

QString SceneView::moveLimitText() const {
    return limitText_;
}

QString SceneView::ghostText() const {
    return ghostText_;
}

std::vector<Camera::Ball> SceneView::inSight() const {
    std::vector<Camera::Ball> balls;
    const auto addArm = [&](const RobotModel& model, const JointPositions& q) {
        for (const collision::LinkCapsule& part :
             collision::placedCapsules(collision::armCapsules(model), model.dh, q)) {
            balls.push_back({part.shape.from, part.shape.radius});
            balls.push_back({part.shape.to, part.shape.radius});
        }
    };
    const auto add = [&](const JointPositions& q) { addArm(model_, q); };
    const double reach = model_.reach;
    if (haveJoints_) {
        add(q_);
        balls.push_back(
            {kinematics::forwardTcp(model_.dh, q_, tcpOffset_).position, kToolAxes * reach / 0.85});
    } else {
        add(JointPositions(0, -std::numbers::pi / 2, 0, -std::numbers::pi / 2, 0, 0));  // upright arm
    }
    if (ghost_ && ghost_->reachable && haveJoints_) {
        add(ghost_->q);
        for (std::size_t i = 0; report_ && i < report_->places.size(); ++i) {
            balls.push_back({report_->places[i], 0});
        }
    }
    if (secondGhost_ && haveJoints_) {
        add(secondGhost_->q);
    }
    if (replay_ && replay_->q.allFinite()) {
        addArm(replayModel(), replay_->q);
    }
    // Ignore positions far away, e.g. taught for another robot. They would make the arm tiny in the view.
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
    // In a small image, the overlay may cover a part of the scene, so that the arm does not become tiny.
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
        camera_.contain(inSight(), margins(size, kMinShare));
    }
}

void SceneView::placeKeys() {
    keys_->move(static_cast<int>(kKeysAt), static_cast<int>(kKeysAt));
    // In a very small image, hide the buttons. The commands remain available.
    keys_->setVisible(keys_->sizeHint().width() + 2 * kKeysAt <= width());
}

QString SceneView::hiddenText(int labels) {
    return labels == 0   ? QString()
           : labels == 1 ? tr("1 name hidden: zoom in")
                         : tr("%n names hidden: zoom in", nullptr, labels);
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
    if (secondGhost_ && haveJoints_) {
        const auto addGhost = [&](const Ghost& ghost, const QString& text) {
            add(kinematics::forwardTcp(model_.dh, ghost.q, tcpOffset_).position, text.arg(ghost.name), true);
        };
        addGhost(*secondGhost_, tr("After: %1"));
        if (ghost_ && ghost_->reachable) {
            addGhost(*ghost_, tr("Before: %1"));
        }
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
    const auto addLimit = [&](const Eigen::Vector3d& place, const QString& text) {
        if (add(place, text, true)) {
            const QPointF at = names.back().at;
            placer.block({at.x() - 2 * kMark, at.y() - 2 * kMark, 4 * kMark, 4 * kMark});
        }
    };
    for (const PathMark& path : paths_) {
        if (path.limit) {
            addLimit(path.limit->place, path.limit->text);
        }
    }
    // Reserve the line that shows the number of hidden labels.
    constexpr double kLineMargin = 12;
    const double words = QFontMetricsF(textFont(13)).horizontalAdvance(hiddenText(99)) + 2;
    const QRectF line(kLineMargin, size.height() - 28,
                      std::min(std::max(size.width() / 2, words), size.width() - 2 * kLineMargin), 22);
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

void SceneView::drawGround(QPainter& painter, const QSize& size) {
    const Theme& theme = Theme::current();
    const double scale = painter.device()->devicePixelRatioF();
    const QSize pixels(static_cast<int>(std::ceil(size.width() * scale)),
                       static_cast<int>(std::ceil(size.height() * scale)));
    if (ground_.size() != pixels || !(camera_.eye() == groundSeenFrom_) || groundScheme_ != theme.scheme) {
        groundSeenFrom_ = camera_.eye();
        groundScheme_ = theme.scheme;
        ground_ = QImage(pixels, QImage::Format_RGB32);
        ground_.setDevicePixelRatio(scale);
        ground_.fill(theme.panel);
        QPainter onGround(&ground_);
        ScenePainter(onGround, camera_, theme)
            .ground(model_.reach, floorHeight().value_or(0), floorHeight().has_value());
    }
    painter.drawImage(QPointF(0, 0), ground_);
}

void SceneView::drawPaths(ScenePainter& scene) {
    const Theme& theme = Theme::current();
    const auto hides = [this](const Camera::Projected& at) { return bodies_->hides(at); };
    if (trace_.points().size() > 1) {
        std::vector<Eigen::Vector3d> places;
        places.reserve(trace_.points().size());
        for (const SceneTrace::Point& point : trace_.points()) {
            places.push_back(point.place);
        }
        scene.path(places, {stale_ ? theme.border : theme.moving, 1.4, false}, hides);
    }
    for (const PathMark& path : paths_) {
        const bool coming = path.kind == PathMark::Kind::Coming;
        scene.path(path.places, {coming ? theme.moving : theme.secondary, coming ? 2.4 : 1.8, coming}, hides);
    }
    if (report_) {
        scene.path(report_->places, {theme.moving, 2.4, true}, hides);
    }
    const auto mark = [&](const Eigen::Vector3d& place) {
        if (const auto at = camera_.project(place); at.visible()) {
            scene.limit(at.point);
        }
    };
    for (const PathMark& path : paths_) {
        if (path.limit) {
            mark(path.limit->place);
        }
    }
    if (report_ && report_->limit) {
        mark(report_->limit->tcp.position);
    }
}

QRectF SceneView::drawJog(ScenePainter& scene) {
    if (!jog_ || stale_) {
        return {};
    }
    const Theme& theme = Theme::current();
    constexpr double kTurnRadius = 0.13;  // as a fraction of the arm's reach
    const double radius = kTurnRadius * model_.reach;
    if (jog_->joint >= 0) {
        const auto frames = kinematics::linkFrames(model_.dh, q_);
        const auto joint = static_cast<std::size_t>(jog_->joint);
        // Draw the arrow around the centre of the joint housing.
        Eigen::Vector3d centre = frames[joint].translation();
        for (const collision::LinkCapsule& part : collision::armCapsules(model_)) {
            if (part.link == jog_->joint + 1) {
                centre = frames[joint + 1] * part.shape.from;
                break;
            }
        }
        return scene.turn(centre, frames[joint].linear().col(2) * jog_->sign, radius, theme.moving,
                          jog_->label);
    }
    const Eigen::Vector3d tcp = kinematics::forwardTcp(model_.dh, q_, tcpOffset_).position;
    return jog_->turns ? scene.turn(tcp, jog_->direction, radius, theme.axis(jog_->axis), jog_->label)
                       : scene.arrow(tcp, jog_->direction, model_.reach, theme.axis(jog_->axis), jog_->label);
}

void SceneView::paintScene(QPainter& painter, const QSizeF& size) {
    const Theme& theme = Theme::current();
    frame(size);
    ScenePainter scene(painter, camera_, theme);
    const double reach = model_.reach;
    drawnAt_ = q_;
    drawGround(painter, size.toSize());
    const bool showsGhost = ghost_ && ghost_->reachable && haveJoints_;
    bodies_->setArm(haveJoints_ ? std::optional(q_) : std::nullopt, stale_);
    // Do not draw a ghost at the position of the arm, because it would cover the arm.
    const auto isApart = [this](const JointPositions& q) {
        return (q.values - q_.values).cwiseAbs().maxCoeff() > kGhostApart;
    };
    bodies_->setGhost(showsGhost && isApart(ghost_->q) ? std::optional(ghost_->q) : std::nullopt);
    bodies_->setSecondGhost(secondGhost_ && haveJoints_ && isApart(secondGhost_->q)
                                ? std::optional(secondGhost_->q)
                                : std::nullopt);
    const bool showsReplay = replay_ && replay_->q.allFinite();
    bodies_->setReplay(showsReplay ? std::optional(replay_->q) : std::nullopt, replayModel());
    bodies_->update(camera_, size.toSize(), painter.device()->devicePixelRatioF(), theme);
    bodies_->paint(painter);
    drawPaths(scene);
    QRectF arrowName;
    if (haveJoints_) {
        const Eigen::Isometry3d T_base_tcp = kinematics::forwardTcp(model_.dh, q_, tcpOffset_).transform();
        scene.axes(T_base_tcp, kToolAxes * reach / 0.85, stale_);
        arrowName = drawJog(scene);
    }
    for (const FrameMark& frame : frames_) {
        scene.axes(frame.T_base_frame.transform(), kFrameAxes * reach / 0.85, !frame.selected);
    }
    drawNames(scene, size, arrowName);
    if (const QString replay = replayHeadline(); !replay.isEmpty()) {
        const double height = size.height() * 0.16;
        const double below = std::min(coveredBelow_, size.height() / 4);
        scene.headline(QRectF(0, size.height() - below - height, size.width(), height), replay);
    }
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
        placeKeys();  // the size of the buttons depends on the density
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
    constexpr double kStep = 12;  // dragging distance that corresponds to one key press [px]
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
            event->ignore();  // Space and Esc stop the robot and are not handled here
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

// Panning and zooming end the automatic fit until the view is fitted again.

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
