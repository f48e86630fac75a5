// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/jog_column.h"

#include <QAbstractButton>
#include <QApplication>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QMenu>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "robot/core/angles.h"
#include "robot/io/outputs.h"
#include "robot/kinematics/speed_bounds.h"
#include "robot/station/jog/retrace_path.h"
#include "robot/station/jog/travel.h"
#include "robot/station/link/obstacles.h"
#include "robot/station/text/format.h"
#include "robot/station/text/notation.h"
#include "robot/station/text/texts.h"
#include "widgets/common/density.h"
#include "widgets/common/segmented_control.h"
#include "widgets/common/text_entry.h"
#include "widgets/hold/hold_guard.h"
#include "widgets/hold/hold_to_run_button.h"
#include "widgets/jog/arm_key.h"
#include "widgets/jog/axis_jog.h"
#include "widgets/jog/jog_pad.h"
#include "widgets/jog/jog_selectors.h"
#include "widgets/jog/joint_rows.h"
#include "widgets/jog/key_ghosts.h"
#include "widgets/jog/keyboard_jog.h"
#include "widgets/jog/limiter_line.h"
#include "widgets/jog/pose_view.h"
#include "widgets/jog/travel_watch.h"

namespace tiller {

using control::StopCause;

namespace {

constexpr int kSideMargin = 12;
constexpr int kSmallMargin = 6;
constexpr int kRefusalShownMs = 6000;
constexpr int kDetailTab = 30;  // height of the selector for pose or joints [px]
/// If the column is lower than this [px], e.g. on a screen of 1280 x 720 with a title bar, the pad buttons
/// and the rows above the pad are smaller.
constexpr int kTightBelow = 570;

/// Button sizes of the pad [px]: kKey for Open and Pairs, kSnugKey for Snug, and for Folded kFoldedKey, or
/// kTightKey if the column is lower than kTightBelow.
constexpr int kKey = 72;
constexpr int kSnugKey = 60;
constexpr int kFoldedKey = 56;
constexpr int kTightKey = 46;

int marginFor(JogColumn::Fold fold) {
    return fold == JogColumn::Fold::Folded || fold == JogColumn::Fold::Snug ? kSmallMargin : kSideMargin;
}

int padHeight(int key) {
    constexpr int kApart = 8;
    return 3 * key + 2 * kApart;
}

// Spacing between the parts of the column, in order.
constexpr int kAbovePad = 2;
constexpr int kAroundLimiter = 4;
constexpr int kBelowPose = 2;
constexpr int kAboveKeys = 8;

double heldFactor() {
    return modifierFactor(QGuiApplication::keyboardModifiers());
}

/// Uses the number of digits that slow joint speeds need: "0.36 °/s", "3.6 °/s", "10 °/s".
QString keySpeedText(double speed) {
    const double degrees = toDegrees(speed);
    return QStringLiteral("%1 °/s").arg(format::number(degrees, degrees < 1 ? 2 : degrees < 9.95 ? 1 : 0));
}

bool near(const JointPositions& a, const JointPositions& b, double distance) {
    return (a.values - b.values).cwiseAbs().maxCoeff() <= distance;
}

}  // namespace

JogColumn::JogColumn(MotionPort port, HoldPolicy& policy, QWidget* parent)
    : Panel(tr("Jog"), parent), port_(std::move(port)) {
    setObjectName(QStringLiteral("jogColumn"));
    setHint(tr("Hold to move"));
    armKey_ = new ArmKey(this);
    armKey_->hide();  // hidden until a keyboard is added
    addHeaderWidget(armKey_);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);

    auto* body = new QWidget(this);
    auto* layout = new QVBoxLayout(body);
    layout->setContentsMargins(0, kSideMargin, 0, kSideMargin);
    layout->setSpacing(0);
    selectors_ = new JogSelectors(port_.limits, body);
    layout->addWidget(selectors_);

    const auto inset = [body](QWidget* widget, int above, int below) {
        auto* row = new QHBoxLayout;
        row->setContentsMargins(kSideMargin, above, kSideMargin, below);
        row->addWidget(widget);
        widget->setParent(body);
        return row;
    };
    pad_ = new JogPad(policy, body);
    limiter_ = new LimiterLine(body);
    pose_ = new PoseView(body);
    detailTab_ = new SegmentedControl({tr("Pose"), tr("Joints")}, body);
    detailTab_->setNames(QStringLiteral("jogDetail"), tr("Pose or joints"));
    joints_ = new JointRows(policy, body);
    layout->addLayout(inset(pad_, kAbovePad, 0), 10);
    layout->addLayout(inset(limiter_, kAroundLimiter, kAroundLimiter));
    layout->addLayout(inset(detailTab_, 0, 2));
    layout->addLayout(inset(pose_, 0, 0));
    layout->addSpacing(kBelowPose);
    layout->addWidget(joints_);
    layout->addStretch(3);
    buildBottom(layout, policy);
    setContent(body);
    // The column folds if there is not enough space (see resizeEvent()), so it can be smaller than the
    // minimum size of its content.
    Panel::layout()->setSizeConstraint(QLayout::SetNoConstraint);

    refusalTimer_ = new QTimer(this);
    refusalTimer_->setSingleShot(true);
    refusalTimer_->setInterval(kRefusalShownMs);
    connect(refusalTimer_, &QTimer::timeout, this, [this] {
        refusal_.clear();
        showReason();
    });
    axisJog_ = new AxisJog(
        port_, selection(), policy, [this] { return deviceObstacle(); }, this);
    connect(axisJog_, &AxisJog::began, this, [this] {
        pose_->pressedHere();
        showJog();
    });
    connect(axisJog_, &AxisJog::turned, this, &JogColumn::showJog);
    connect(axisJog_, &AxisJog::ended, this, &JogColumn::showJog);
    connect(axisJog_, &AxisJog::refused, this, [this](const QString& reason) {
        refusal_ = reason;
        refusalTimer_->start();
        showReason();
        Q_EMIT refused(reason);
    });
    ghosts_ = new KeyGhosts(this);
    connect(ghosts_, &KeyGhosts::wanted, this, &JogColumn::ghostWanted);
    connect(ghosts_, &KeyGhosts::gone, this, &JogColumn::ghostHidden);
    connectKeys();
    connectBottom();
    connect(selectors_, &JogSelectors::changing, this, &JogColumn::stopMotion);
    connect(selectors_, &JogSelectors::changed, this, [this] {
        setHint(stepRunsToEnd(selection(), false) ? tr("Press for one step") : tr("Hold to move"));
        showFrame();
        speedsKnown_ = false;
        showSpeeds();
        Q_EMIT speedChanged();
    });
    connect(detailTab_, &SegmentedControl::currentChanged, this, [this] {
        stopMotion(StopCause::SelectionChanged);
        arrange();
    });
    travel_ = new TravelWatch(*pad_, selection(), this);
    showFrame();
    arrange();
    applyState(SessionState());
}

JogColumn::JogColumn(RobotSession& session, HoldPolicy& policy, QWidget* parent)
    : JogColumn(motionPort(session), policy, parent) {
    applyState(session.state());
    connect(&session, &RobotSession::stateChanged, this, &JogColumn::applyState);
}

const JogSelection& JogColumn::selection() const {
    return selectors_->selection();
}

JogColumn::~JogColumn() {
    stopMotion(StopCause::WindowClosed);
}

std::vector<JointPositions> JogColumn::retracePath() const {
    return {track_->places().begin(), track_->places().end()};
}

void JogColumn::setHome(const JointPositions& home, bool ofProject) {
    home_ = home;
    homeOfProject_ = ofProject;
    speedsKnown_ = false;
    showSpeeds();
}

QVector<HoldToRunButton*> JogColumn::holdKeys() const {
    QVector<HoldToRunButton*> keys;
    for (JogKey* key : pad_->keys()) {
        keys.append(key);
    }
    for (const JointRow* row : joints_->rows()) {
        keys << row->minusKey() << row->plusKey();
    }
    keys << freedrive_ << homeKey_ << align_ << back_;
    return keys;
}

void JogColumn::stopMotion(StopCause cause) {
    for (HoldToRunButton* key : holdKeys()) {
        key->guard().stop(cause);
    }
    axisJog_->stop(cause);
}

bool JogColumn::isHolding() const {
    for (const HoldToRunButton* key : holdKeys()) {
        if (key->isHolding()) {
            return true;
        }
    }
    return axisJog_->isActive();
}

void JogColumn::applyState(const SessionState& state) {
    const bool sameConditions = state.speedFraction == state_.speedFraction &&
                                state.speedCap == state_.speedCap && state.hasData() == state_.hasData() &&
                                state.tcpOffset == state_.tcpOffset && state.model == state_.model;
    state_ = state;
    ghosts_->setState(state);
    travel_->setState(state);
    armKey_->setLock(state.monitorOnly ? texts::monitorOnlyObstacle() : QString());
    const bool canMove = state.canMove();
    if (!canMove) {
        stopMotion(stopCauseFor(state));
    }
    const bool valid = state.hasData();
    if (state.link == LinkState::Disconnected || state.link == LinkState::Connecting) {
        track_->clear();
        payloadChecked_ = true;
    } else if (valid && state.link == LinkState::Live) {
        track_->record(state.q);
    }
    reportRetracePath();
    const bool stale = state.link != LinkState::Live;
    pose_->setPose(state.tcpPose, state.moving, valid, stale);
    joints_->setJoints(state.q, state.moving, valid, stale);
    pose_->setTcp(state.tcpOffset);
    // With outdated data, keep showing the last speed.
    pose_->setSpeed(state.moving || !state.isFresh() ? state.tcpSpeed : Twist());
    lightKeys();
    if (shownJog_) {
        showJog();  // the direction rotates with the tool frame
    }
    showFactor();
    if (!sameConditions || !near(state.q, speedsAt_, 0.01)) {
        speedsKnown_ = false;
    }
    showSpeeds();
    showReason();
}

void JogColumn::reportRetracePath() {
    // Emit at most once in six frames (10 Hz at 60 frames per second), because the path can have thousands of
    // positions.
    constexpr int kFrames = 6;
    if (++retracePathFrames_ >= kFrames && track_->revision() != retracePathReported_) {
        retracePathFrames_ = 0;
        retracePathReported_ = track_->revision();
        Q_EMIT retracePathChanged();
    }
}

void JogColumn::showFrame() {
    pose_->setFrame(readingFrameName(selection()), readingFrame(selection()));
}

void JogColumn::lightKeys() {
    for (HoldToRunButton* key : holdKeys()) {
        key->setConfirmed(state_.moving && key->isHolding());
    }
    if (!state_.moving || !axisJog_->isActive()) {
        return;
    }
    for (JogKey* key : pad_->keys()) {
        key->setConfirmed(isDriven(*key));
    }
    for (const JointRow* row : joints_->rows()) {
        row->minusKey()->setConfirmed(isDriven(row->joint(), -1));
        row->plusKey()->setConfirmed(isDriven(row->joint(), 1));
    }
}

/// True if the current keyboard or device input includes the direction of this pad button.
bool JogColumn::isDriven(const JogKey& key) const {
    return axisJog_->isActive() && axisJog_->input().axes[key.key().axis] * key.key().direction > 0;
}

bool JogColumn::isDriven(int joint, int direction) const {
    const Deflection& input = axisJog_->input();
    return axisJog_->isActive() && input.axes.isZero() && input.joints[joint] * direction > 0;
}

std::optional<ShownJog> JogColumn::shownJog() const {
    ShownJog shown;
    Vector6 wish = Vector6::Zero();  // requested direction, one component per pad axis
    QStringList names;
    for (const JogKey* key : pad_->keys()) {
        if (key->isHolding()) {
            wish[key->key().axis] = key->key().direction;
        }
    }
    if (axisJog_->isActive()) {
        wish = axisJog_->input().axes;
    }
    // Components below this fraction of the largest component are not named.
    constexpr double kNamed = 0.2;
    const double most = wish.cwiseAbs().maxCoeff();
    for (int axis = 0; axis < 6; ++axis) {
        if (most > 0 && std::abs(wish[axis]) >= kNamed * most) {
            names << travelKeyName(2 * axis + (wish[axis] > 0 ? 1 : 0));
        }
    }
    if (!names.isEmpty()) {
        // If translation and rotation are combined, the arrow shows the translation.
        const Eigen::Vector3d along = wish.head<3>().isZero() ? wish.tail<3>() : wish.head<3>();
        along.cwiseAbs().maxCoeff(&shown.axis);
        shown.turns = wish.head<3>().isZero();
        shown.direction = frameAxes(selection(), state_.tcpPose) * along;
        shown.frameName = frameName(selection());
    }
    for (const JointRow* row : joints_->rows()) {
        for (const auto& [key, direction] : {std::pair{row->minusKey(), -1}, {row->plusKey(), 1}}) {
            if (isDriven(row->joint(), direction) || key->isHolding()) {
                names << row->accessibleName() + key->text();
                shown.joint = row->joint();
                shown.sign = direction;
            }
        }
    }
    if (back_->isHolding()) {
        names << back_->accessibleName();
    }
    shown.label = names.join(QLatin1Char(' '));
    return names.isEmpty() ? std::nullopt : std::optional(shown);
}

void JogColumn::showJog() {
    const std::optional<ShownJog> shown = shownJog();
    lightKeys();
    showFactor();
    if (shown != shownJog_) {
        shownJog_ = shown;
        Q_EMIT jogShown(shown);
    }
}

/// Shows the speed factor of the current motion, or of the next motion.
void JogColumn::showFactor() {
    double factor = axisJog_->isActive() ? axisJog_->factor()
                    : isHolding()        ? keyFactor_
                    : isActiveWindow()   ? heldFactor()
                                         : 1;
    if (selection().motion == MotionChoice::UntilContact) {
        factor = std::min(factor, 1.0);  // a move until contact must not be faster than the selected speed
    }
    pose_->setFactor(factor);
}

HeldSpeed JogColumn::heldSpeed() const {
    const SpeedClass chosen = chosenSpeed(selection());
    return {chosen.tcp, chosen.rotation, chosen.joint};
}

/// Shows the speeds of the joint buttons and of the buttons that move to a position.
void JogColumn::showSpeeds() {
    if (speedsKnown_ || isHolding()) {
        return;  // the speed of the current motion does not change
    }
    speedsKnown_ = true;
    speedsAt_ = state_.q;
    const bool known = state_.hasData();
    const auto text = [&](const MoveRequest& request) {
        return known ? moveSpeedText(request, state_) : QString();
    };
    homeKey_->setDetail(
        text(homeMove(selection(), state_.q, home_, state_.arm(), state_.tcpOffset, port_.limits())));
    align_->setDetail(text(alignMove(selection(), state_.tcpPose, port_.limits())));
    MoveRequest back;
    back.q = track_->nextPlace().value_or(state_.q);
    back.speed = track_->speed();
    back_->setDetail(text(back));
    const double slider = std::max(state_.speedFraction, io::kLowestSpeedFraction);
    for (JointRow* row : joints_->rows()) {
        const double speed = jointKeySpeed(selection(), row->joint(), 1, state_.q, state_.arm(),
                                           state_.tcpOffset, port_.limits());
        row->setSpeed(known ? keySpeedText(speed * slider) : QString());
    }
}

void JogColumn::showReason() {
    const QString reason = cannotMoveReason(state_);
    pad_->setReason(reason);
    for (const JointRow* row : joints_->rows()) {
        row->minusKey()->setUnavailable(reason);
        row->plusKey()->setUnavailable(reason);
    }
    homeKey_->setUnavailable(reason);
    align_->setUnavailable(reason);
    freedrive_->setUnavailable(reason);
    back_->setUnavailable(!reason.isEmpty() ? reason
                          : track_->isEmpty() && !back_->isHolding()
                              ? tr("There is no path to retrace. Jog the arm first.")
                              : QString());
    if (const QString last = countdown(); !last.isEmpty()) {
        limiter_->setLimiter({last, tr("release and press again")});
    } else if (!refusal_.isEmpty() && reason.isEmpty()) {
        limiter_->setLimiter({refusal_, {}});
    } else {
        showLimiter();
    }
    limiter_->setQuietText(quietText());
}

QSize JogColumn::minimumSizeHint() const {
    return {352, 540};
}

JogColumn::Rows JogColumn::rowsFor(Fold fold) const {
    switch (fold) {
        case Fold::Open:
        case Fold::Pairs:
            return {std::max(38, finger_), 6};
        case Fold::Snug:
            return {26, 3};
        case Fold::Folded:
            break;
    }
    return {std::max(height() < kTightBelow ? 26 : 30, finger_), 3};
}

int JogColumn::keyFor(Fold fold) const {
    switch (fold) {
        case Fold::Open:
        case Fold::Pairs:
            return kKey;
        case Fold::Snug:
            return kSnugKey;
        case Fold::Folded:
            break;
    }
    return finger_ > 0 ? finger_ : height() < kTightBelow ? kTightKey : kFoldedKey;
}

int JogColumn::heightFor(Fold fold) const {
    constexpr int kFrame = 3;  // borders of the panel and the line below its title
    const auto [row, apart] = rowsFor(fold);
    const int joints = JointRows::heightWhen(fold == Fold::Pairs, fold == Fold::Snug);
    const int header = std::max(Panel::kHeaderHeight, finger_);  // includes the button that arms the keyboard
    return header + kFrame + 2 * marginFor(fold) + selectors_->heightWhen(row, apart) + kAbovePad +
           padHeight(keyFor(fold)) + limiter_->sizeHint().height() + 2 * kAroundLimiter +
           pose_->minimumSizeHint().height() + kBelowPose + joints + kAboveKeys +
           freedrive_->sizeHint().height();
}

JogColumn::Fold JogColumn::foldFor(int height) const {
    if (height >= heightFor(Fold::Open)) {
        return Fold::Open;
    }
    // With Touch density, buttons do not become smaller. The column shows the joints in pairs or folds
    // instead.
    const Fold next = currentDensity() == Density::Touch ? Fold::Pairs : Fold::Snug;
    return height >= heightFor(next) ? next : Fold::Folded;
}

void JogColumn::resizeEvent(QResizeEvent* event) {
    Panel::resizeEvent(event);
    fold();
}

void JogColumn::fold() {
    finger_ = touchHeight();
    fold_ = foldFor(height());
    arrange();
    pad_->setMinimumHeight(padHeight(keyFor(fold_)));
}

void JogColumn::arrange() {
    const bool folded = fold_ == Fold::Folded;
    const bool jointsChosen = detailTab_->currentIndex() == 1;
    joints_->setCompact(folded || fold_ == Fold::Pairs);
    joints_->setLow(fold_ == Fold::Snug);
    detailTab_->setVisible(folded);
    detailTab_->setFixedHeight(std::max(kDetailTab, finger_));
    pose_->setVisible(!folded || !jointsChosen);
    joints_->setVisible(!folded || jointsChosen);
    const auto [row, apart] = rowsFor(fold_);
    selectors_->setRowHeight(row, apart);
    const int edge = marginFor(fold_);
    content()->layout()->setContentsMargins(0, edge, 0, edge);
    pad_->setMaximumHeight(folded ? QWIDGETSIZE_MAX : padHeight(kKey));
}

// ---- buttons and their motions ------------------------------------------------------------------

void JogColumn::buildBottom(QVBoxLayout* layout, HoldPolicy& policy) {
    const auto make = [this, &policy](const QString& text, const char* name, const QString& tip) {
        auto* key = new HoldToRunButton(text, policy, this);
        key->setObjectName(QLatin1String(name));
        key->setToolTip(tip);
        key->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        return key;
    };
    freedrive_ = make(tr("Freedrive"), "freedriveKey", {});
    homeKey_ =
        make(tr("Home"), "homeKey", tr("Moves all joints to the home position while the button is held"));
    align_ = make(tr("Align"), "alignKey",
                  tr("Aligns the tool with the nearest axis of the selected frame while the button is held"));
    back_ = make(QStringLiteral("↶ ") + tr("Back"), "backKey",
                 tr("Retraces the last motion while the button is held"));
    back_->setAccessibleName(tr("Back"));
    auto* row = new QHBoxLayout;
    row->setContentsMargins(kSideMargin, kAboveKeys, kSideMargin, 0);
    row->setSpacing(8);
    for (HoldToRunButton* key : {freedrive_, homeKey_, align_, back_}) {
        row->addWidget(key);
    }
    layout->addLayout(row);
}

void JogColumn::guardMotion(HoldToRunButton* key, HoldMotion motion, bool modified) {
    motion.begin = [this, begin = std::move(motion.begin)]() -> Result<RobotSession::MotionId> {
        if (!state_.canMove()) {
            return Error{ErrorCode::NotInControl, cannotMoveReason(state_), {}};
        }
        return begin();
    };
    key->setMotion(std::move(motion));
    connect(&key->guard(), &HoldGuard::began, this, [this, modified] {
        refusal_.clear();
        keyFactor_ = modified ? heldFactor() : 1;
        pose_->pressedHere();
        showReason();
        showJog();
    });
    connect(&key->guard(), &HoldGuard::ended, this, &JogColumn::showJog);
    connect(&key->guard(), &HoldGuard::refused, this, [this](const Error& error) {
        // Errors detected by Tiller already contain a complete sentence.
        const bool own = !state_.canMove() || error.code == ErrorCode::UnsafeState ||
                         error.code == ErrorCode::Cancelled ||
                         (error.code == ErrorCode::NoSolution && error.controllerMessage.isEmpty());
        refusal_ = !state_.canMove() ? cannotMoveReason(state_)
                   : own             ? error.context
                                     : texts::errorText(error);
        refusalTimer_->start();
        showReason();
        Q_EMIT refused(refusal_);
    });
}

void JogColumn::guardKey(HoldToRunButton* key, const Begin& begin, Steps steps) {
    guardMotion(key,
                {
                    .begin = begin,
                    .hold = port_.hold,
                    .end = port_.endMotion,
                    .runsToEnd =
                        [this, steps] {
                            return steps != Steps::None && stepRunsToEnd(selection(), steps == Steps::Turns);
                        },
                    .bounds = [this] { return bounds_; },
                },
                steps != Steps::None);
}

void JogColumn::connectKeys() {
    for (JogKey* key : pad_->keys()) {
        const CartesianKey axis = key->key();
        const auto step = [this, axis] {
            return cartesianStep(selection(), axis, heldFactor(), state_.tcpPose, port_.limits());
        };
        guardKey(
            key,
            [this, axis, step] {
                return isHeld(selection().motion)
                           ? beginJog(cartesianJog(selection(), axis, heldFactor(), port_.limits()))
                           : beginMove(step());
            },
            axis.axis < 3 ? Steps::Lengths : Steps::Turns);
        ghosts_->offer(*key, key->text(), [this, axis, step]() -> std::optional<MoveRequest> {
            const bool far = !isHeld(selection().motion) && !stepRunsToEnd(selection(), axis.axis >= 3);
            return far ? std::optional(step()) : std::nullopt;
        });
    }
    for (JointRow* row : joints_->rows()) {
        for (const auto& [key, direction] : {std::pair{row->minusKey(), -1}, {row->plusKey(), 1}}) {
            const auto step = [this, joint = row->joint(), direction = direction] {
                return jointStep(selection(), joint, direction, heldFactor(), state_.q, state_.arm(),
                                 state_.tcpOffset, port_.limits());
            };
            guardKey(
                key,
                [this, joint = row->joint(), direction = direction, step] {
                    return isHeld(selection().motion) ? beginJog(jointJog(selection(), joint, direction,
                                                                          heldFactor(), port_.limits()))
                                                      : beginMove(step());
                },
                Steps::Turns);
            ghosts_->offer(*key, key->accessibleName(), [this, step]() -> std::optional<MoveRequest> {
                const bool far = !isHeld(selection().motion) && !stepRunsToEnd(selection(), true);
                return far ? std::optional(step()) : std::nullopt;
            });
        }
    }
}

void JogColumn::connectBottom() {
    const auto home = [this] {
        MoveRequest move =
            homeMove(selection(), state_.q, home_, state_.arm(), state_.tcpOffset, port_.limits());
        move.toProject = homeOfProject_;
        return move;
    };
    guardKey(
        homeKey_, [this, home] { return beginMove(home()); }, Steps::None);
    ghosts_->offer(*homeKey_, tr("home"), home);
    const auto align = [this] { return alignMove(selection(), state_.tcpPose, port_.limits()); };
    guardKey(
        align_, [this, align] { return beginMove(align()); }, Steps::None);
    ghosts_->offer(*align_, tr("aligned"), align);
    guardKey(
        freedrive_, [this] { return beginFreedrive(); }, Steps::None);
    setFreedriveAxes(freedriveAxes_);
    freedrive_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(freedrive_, &QWidget::customContextMenuRequested, this, [this](const QPoint& at) {
        stopMotion(StopCause::DialogOpened);
        QMenu menu(this);
        fillFreedriveMenu(menu);
        menu.exec(freedrive_->mapToGlobal(at));
    });

    track_ = std::make_unique<RetracePath>(port_, [this](const JointPositions& from,
                                                         const JointPositions& to) {
        const control::MotionLimits limits = port_.limits();
        const SpeedClass chosen = chosenSpeed(selection());
        const double tcpSpeed = std::min(chosen.tcp, limits.tcpSpeed);
        return std::min({chosen.joint, limits.jointSpeed,
                         kinematics::jointSpeedBound(state_.dh, from, to, state_.tcpOffset, tcpSpeed).speed});
    });
    guardMotion(back_, track_->motion(), false);
    for (HoldToRunButton* key : {homeKey_, align_, back_}) {
        key->setWidestDetail(QStringLiteral("000 mm/s"));
    }
}

HoldGuard* JogColumn::stepButton(const Deflection& wish) const {
    if ((wish.axes.array() != 0).count() + (wish.joints.array() != 0).count() != 1) {
        return nullptr;
    }
    for (JogKey* key : pad_->keys()) {
        if (wish.axes[key->key().axis] * key->key().direction > 0) {
            return &key->guard();
        }
    }
    for (const JointRow* row : joints_->rows()) {
        if (const double direction = wish.joints[row->joint()]; direction != 0) {
            return &(direction > 0 ? row->plusKey() : row->minusKey())->guard();
        }
    }
    return nullptr;
}

void JogColumn::addHoldKeys(KeyboardJog& keyboard) {
    keyboard.addHoldKey(Qt::Key_F, freedrive_->guard());
    keyboard.addHoldKey(Qt::Key_Home, homeKey_->guard());
    keyboard.addHoldKey(Qt::Key_End, align_->guard());
    keyboard.addHoldKey(Qt::Key_Backspace, back_->guard());
    keyboard.setSteps({[this] { return !isHeld(selection().motion); },
                       [this](const Deflection& wish) { return stepButton(wish); }});
    armKey_->show();
    connect(armKey_, &QAbstractButton::clicked, &keyboard, [&keyboard] {
        // Clear the focus of a text field, because it would also receive the keys.
        if (QWidget* focus = QApplication::focusWidget(); takesText(focus)) {
            focus->clearFocus();
        }
        keyboard.setArmed(!keyboard.isArmed());
    });
    connect(&keyboard, &KeyboardJog::armedChanged, armKey_, &ArmKey::setArmed);
}

Result<RobotSession::MotionId> JogColumn::beginJog(const control::JogTarget& target) {
    bounds_ = {0, jogTimeoutNs(target)};
    return port_.beginJog(target);
}

Result<RobotSession::MotionId> JogColumn::beginMove(const MoveRequest& request) {
    const bool linear = request.kind == MoveRequest::Kind::MoveL;
    bounds_ = {HoldBounds::longestOf(moveSeconds(request, state_)),
               HoldBounds::holdTimeoutAt(linear ? request.speed : 0, linear ? 0 : request.speed)};
    return port_.beginMove(request);
}

/// The remaining time of a motion without a defined end, during the last seconds before the maximum hold
/// duration.
QString JogColumn::countdown() const {
    constexpr std::int64_t kCountdownNs = 3 * kNsPerSecond;
    std::int64_t left = axisJog_->leftNs();
    for (const HoldToRunButton* key : holdKeys()) {
        left = std::min(left, key->holdLeftNs());
    }
    if (left > kCountdownNs || !isHolding()) {
        return {};
    }
    return tr("Ends in %1 s").arg(std::max<std::int64_t>(0, (left + kNsPerSecond - 1) / kNsPerSecond));
}

Result<RobotSession::MotionId> JogColumn::beginFreedrive() {
    if (payloadChecked_) {
        if (const QString doubt = payloadDoubt(state_); !doubt.isEmpty()) {
            return Error{ErrorCode::UnsafeState, doubt, {}};
        }
    }
    constexpr std::int64_t kMaxFreedriveNs = 5 * 60 * kNsPerSecond;
    bounds_ = {kMaxFreedriveNs, HoldBounds::kMaxHoldTimeoutNs};
    return port_.beginFreedrive(
        freedriveOf(freedriveAxes_, frameAxes(selection(), state_.tcpPose), state_.tcpPose));
}

QString JogColumn::deviceObstacle() const {
    if (const QString reason = cannotMoveReason(state_); !reason.isEmpty()) {
        return reason;
    }
    // Only one motion is permitted at a time.
    return isHolding() ? tr("Another button or key is already held. Release it first.") : QString();
}

// ---- display ---------------------------------------------------------------------------------------

void JogColumn::showLimiter() {
    // Skip small changes, because evaluating all twelve directions in every frame of a moving arm would take
    // too long.
    const double unchanged = state_.motionActive ? 0.02 : 0.002;
    const bool sameLimit = state_.limiter.kind == limiterSeen_.kind &&
                           std::abs(state_.limiter.scale - limiterSeen_.scale) < 0.03;
    const Eigen::Matrix3d axes = frameAxes(selection(), state_.tcpPose);
    const bool sameFrame = state_.motionActive || axes.isApprox(limiterIn_, 1e-3);
    if (!state_.hasData()) {
        nearest_ = {};
        limiterAt_ = {};
        limiterWith_.reset();
    } else if (!sameLimit || !sameFrame || state_.check != limiterWith_ ||
               !near(state_.q, limiterAt_, unchanged)) {
        nearest_ = nearestLimiter(state_, axes);
        limiterAt_ = state_.q;
        limiterSeen_ = state_.limiter;
        limiterWith_ = state_.check;
        limiterIn_ = axes;
    }
    limiter_->setLimiter(nearest_);
}

QString JogColumn::quietText() const {
    if (const QString held = travel_->heldText(); !held.isEmpty()) {
        return held;
    }
    const control::StopMeasurement& stop = state_.lastStop;
    if (!state_.lastStopSeen) {
        const control::UnmeasuredStop& lost = state_.unmeasuredStop;
        return lost.cause == StopCause::None
                   ? tr("Last stop: not measured (data lost)")
                   : tr("Last stop: %1 (%2)")
                         .arg(texts::stopCauseText(lost.cause), texts::unmeasuredText(lost.reason));
    }
    if (stop.count == 0) {
        return {};
    }
    return tr("Last stop: %1, standstill after %2 ms, %3")
        .arg(texts::stopCauseText(stop.cause))
        .arg(stop.durationMs, 0, 'f', 0)
        .arg(format::length(stop.distanceMm / 1e3, 1));
}

void JogColumn::zeroHere() {
    pose_->zeroHere();
}

void JogColumn::setFreedriveAxes(FreedriveAxes axes) {
    freedrive_->guard().stop(StopCause::SelectionChanged);
    freedriveAxes_ = axes;
    freedrive_->setToolTip(
        tr("Move the arm by hand while this button is held: %1. Right-click to select axes.")
            .arg(freedriveAxesText(axes)));
    freedrive_->setAccessibleName(tr("Freedrive, %1").arg(freedriveAxesText(axes)));
    freedrive_->setText(axes == FreedriveAxes::All ? tr("Freedrive") : tr("Freedrive…"));
}

void JogColumn::fillFreedriveMenu(QMenu& menu) {
    for (const FreedriveAxes axes : kFreedriveAxes) {
        QAction* action =
            menu.addAction(freedriveAxesText(axes), this, [this, axes] { setFreedriveAxes(axes); });
        action->setCheckable(true);
        action->setChecked(axes == freedriveAxes_);
    }
    menu.addSeparator();
    QAction* check = menu.addAction(tr("Check payload before Freedrive (resets on reconnect)"), this,
                                    [this] { payloadChecked_ = !payloadChecked_; });
    check->setCheckable(true);
    check->setChecked(payloadChecked_);
}

void JogColumn::changeEvent(QEvent* event) {
    // travel_ is created last. If it is null, the column is not complete yet.
    if (event->type() == QEvent::StyleChange && travel_ != nullptr) {
        selectors_->refreshTexts();  // units may have changed
        travel_->reset();
        speedsKnown_ = false;
        showSpeeds();
        showReason();
        fold();  // the required space depends on the button size
    }
    Panel::changeEvent(event);
}

}  // namespace tiller

#include "moc_jog_column.cpp"
