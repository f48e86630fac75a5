// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/jog_column.h"

#include <QAbstractButton>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QMenu>
#include <QTimer>
#include <QVBoxLayout>

#include "widgets/common/hold_button.h"
#include "widgets/common/segmented_control.h"
#include "widgets/common/theme.h"
#include "widgets/jog/axis_jog.h"
#include "widgets/jog/back_track.h"
#include "widgets/jog/jog_pad.h"
#include "widgets/jog/joint_rows.h"
#include "widgets/jog/limiter_line.h"
#include "widgets/jog/pose_view.h"
#include "widgets/jog/reasons.h"
#include "widgets/session/texts.h"

namespace tiller {

using control::StopCause;

namespace {

constexpr int kMargin = 12;
constexpr int kTaughtSegment = 3;
constexpr int kLongestName = 84;  // [px] of a frame, on its key
constexpr int kRefusalShownMs = 6000;
constexpr int kLookMs = 40;
/// Below this height of the column the joints move into a tab.
constexpr int kCompactBelow = 800;
/// Below this one, on a screen of 1280 x 720 under a title bar, the keys of the pad give way a little.
constexpr int kTightBelow = 570;

}  // namespace

JogColumn::JogColumn(JogPort port, QWidget* parent) : Panel(tr("Jog"), parent), port_(std::move(port)) {
    setObjectName(QStringLiteral("jogColumn"));
    setHint(tr("Hold to move · release to stop"));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);

    auto* body = new QWidget(this);
    auto* layout = new QVBoxLayout(body);
    layout->setContentsMargins(0, kMargin, 0, kMargin);
    layout->setSpacing(0);
    buildSelectors(layout);

    const auto inset = [body](QWidget* widget, int above, int below) {
        auto* row = new QHBoxLayout;
        row->setContentsMargins(kMargin, above, kMargin, below);
        row->addWidget(widget);
        widget->setParent(body);
        return row;
    };
    pad_ = new JogPad(body);
    limiter_ = new LimiterLine(body);
    pose_ = new PoseView(body);
    detailTab_ = new SegmentedControl({tr("Pose"), tr("Joints")}, body);
    detailTab_->setNames(QStringLiteral("jogDetail"), tr("Shown below the pad"));
    joints_ = new JointRows(body);
    layout->addLayout(inset(pad_, 2, 0), 10);
    layout->addLayout(inset(limiter_, 4, 4));
    layout->addLayout(inset(detailTab_, 0, 2));
    layout->addLayout(inset(pose_, 0, 0));
    layout->addSpacing(2);
    layout->addWidget(joints_);
    layout->addStretch(3);
    buildBottom(layout);
    setContent(body);
    // The column folds itself below what its content would like; see resizeEvent().
    Panel::layout()->setSizeConstraint(QLayout::SetNoConstraint);

    refusalTimer_ = new QTimer(this);
    refusalTimer_->setSingleShot(true);
    refusalTimer_->setInterval(kRefusalShownMs);
    connect(refusalTimer_, &QTimer::timeout, this, [this] {
        refusal_.clear();
        showReason();
    });
    axisJog_ = new AxisJog(
        port_, selection_, [this] { return deviceObstacle(); }, this);
    connect(axisJog_, &AxisJog::began, this, [this] { pose_->pressedHere(); });
    connect(axisJog_, &AxisJog::refused, this, [this](const QString& reason) {
        refusal_ = reason;
        refusalTimer_->start();
        showReason();
        Q_EMIT refused(reason);
    });
    connectKeys();
    connectBottom();
    connectSelectors();
    // One direction at a time, so that no frame has to wait for twelve.
    auto* lookTimer = new QTimer(this);
    lookTimer->setInterval(kLookMs);
    connect(lookTimer, &QTimer::timeout, this, &JogColumn::lookAround);
    lookTimer->start();
    showFrames();
    showMotionTexts();
    arrange();
    applyState(SessionState());
}

JogColumn::JogColumn(RobotSession& session, QWidget* parent) : JogColumn(sessionPort(session), parent) {
    applyState(session.state());
    connect(&session, &RobotSession::stateChanged, this, &JogColumn::applyState);
}

JogColumn::~JogColumn() {
    stopMotion(StopCause::WindowClosed);
}

void JogColumn::buildSelectors(QVBoxLayout* layout) {
    auto* grid = new QGridLayout;
    grid->setContentsMargins(kMargin, 0, kMargin, 6);
    grid->setHorizontalSpacing(0);
    grid->setVerticalSpacing(10);
    grid->setColumnMinimumWidth(0, 62);
    frame_ = new SegmentedControl({tr("Base"), tr("Tool"), tr("View"), tr("Frame")}, this);
    frame_->setNames(QStringLiteral("jogFrame"), tr("Frame"));
    // The other words follow the operator's units; see showMotionTexts().
    motion_ = new SegmentedControl({tr("Hold"), {}, {}, {}}, this);
    motion_->setNames(QStringLiteral("jogMotion"), tr("Motion"));
    motion_->segment(0)->setToolTip(tr("Moves while the key is held"));
    speed_ = new SegmentedControl(QStringList(kSpeedClassCount), this);
    speed_->setNames(QStringLiteral("jogSpeed"), tr("Speed"));
    speed_->setCurrentIndex(kStartSpeedClass);
    int row = 0;
    for (const auto& [text, control] :
         {std::pair{tr("Frame"), frame_}, {tr("Motion"), motion_}, {tr("Speed"), speed_}}) {
        auto* label = new QLabel(text, this);
        label->setFont(textFont(15));
        label->setProperty("role", QStringLiteral("secondary"));
        grid->addWidget(label, row, 0);
        grid->addWidget(control, row, 1);
        ++row;
    }
    grid->setColumnStretch(1, 1);
    layout->addLayout(grid);
}

void JogColumn::connectSelectors() {
    connect(frame_, &SegmentedControl::currentChanged, this, &JogColumn::chooseFrame);
    connect(motion_, &SegmentedControl::currentChanged, this, [this](int index) {
        stopMotion(StopCause::SelectionChanged);
        selection_.motion = static_cast<MotionChoice>(index);
        if (selection_.motion != MotionChoice::CoarseStep) {
            selection_.step.reset();
        }
        showMotionTexts();
    });
    connect(speed_, &SegmentedControl::currentChanged, this, [this](int index) {
        stopMotion(StopCause::SelectionChanged);
        selection_.speedClass = index;
        selection_.speed.reset();
        showMotionTexts();
    });
    offerChoices(motion_, static_cast<int>(MotionChoice::CoarseStep),
                 [this](QMenu& menu) { fillStepMenu(menu); });
    offerChoices(speed_, kSpeedClassCount - 1, [this](QMenu& menu) { fillSpeedMenu(menu); });
    connect(detailTab_, &SegmentedControl::currentChanged, this, [this] {
        stopMotion(StopCause::SelectionChanged);
        arrange();
    });
    // With several taught frames the fourth key opens the list.
    connect(frame_->segment(kTaughtSegment), &QAbstractButton::clicked, this, [this] {
        if (frames_.size() < 2) {
            return;
        }
        stopMotion(StopCause::SelectionChanged);
        QMenu menu(this);
        for (const TaughtFrame& taught : frames_) {
            menu.addAction(taught.name, this, [this, id = taught.id] { chooseTaughtFrame(id); });
        }
        const QWidget* key = frame_->segment(kTaughtSegment);
        menu.exec(key->mapToGlobal(QPoint(0, key->height())));
    });
}

void JogColumn::chooseFrame(int segment) {
    stopMotion(StopCause::SelectionChanged);
    selection_.frame = static_cast<FrameChoice>(segment);
    if (selection_.frame == FrameChoice::Taught && !selection_.taught && !frames_.isEmpty()) {
        selection_.taught = frames_.first();
        showFrames();
    }
}

void JogColumn::showFrames() {
    frame_->setSegmentEnabled(
        static_cast<int>(FrameChoice::View), hasView_,
        hasView_ ? tr("Axes of the picture: X right, Y away from you, Z up") : tr("Needs the 3D view"));
    const bool any = !frames_.isEmpty();
    const QString name =
        any ? (selection_.taught ? selection_.taught->name : frames_.first().name) : tr("Frame");
    // A name may be longer than a key.
    const QString shown =
        QFontMetrics(textFont(15, QFont::Bold)).elidedText(name, Qt::ElideRight, kLongestName);
    frame_->setText(kTaughtSegment, frames_.size() > 1 ? shown + QStringLiteral(" ▾") : shown);
    frame_->setSegmentEnabled(kTaughtSegment, any,
                              any ? name : tr("No frame taught yet. Teach one in the tab Frames."));
}

void JogColumn::setViewRotation(const Eigen::Matrix3d& R_base_view) {
    if (selection_.frame == FrameChoice::View && !selection_.R_base_view.isApprox(R_base_view, 1e-9)) {
        stopMotion(StopCause::SelectionChanged);
    }
    selection_.R_base_view = R_base_view;
    if (!hasView_) {
        hasView_ = true;
        showFrames();
    }
}

void JogColumn::setTaughtFrames(const QVector<TaughtFrame>& frames) {
    if (selection_.frame == FrameChoice::Taught) {
        stopMotion(StopCause::SelectionChanged);
    }
    frames_ = frames;
    const TaughtFrame* same = nullptr;
    for (const TaughtFrame& taught : frames_) {
        // By its id: a frame with another name is the same frame.
        if (selection_.taught && taught.id == selection_.taught->id) {
            same = &taught;
        }
    }
    if (same != nullptr) {
        selection_.taught = *same;
    } else {
        selection_.taught.reset();
        if (selection_.frame == FrameChoice::Taught) {
            frame_->setCurrentIndex(static_cast<int>(FrameChoice::Base));
        }
    }
    showFrames();
}

void JogColumn::chooseTaughtFrame(const QUuid& frame) {
    for (const TaughtFrame& taught : frames_) {
        if (taught.id == frame) {
            stopMotion(StopCause::SelectionChanged);
            selection_.taught = taught;
            frame_->setCurrentIndex(kTaughtSegment);
            showFrames();
            return;
        }
    }
}

void JogColumn::setSpeedClass(int index) {
    stopMotion(StopCause::SelectionChanged);
    selection_.speed.reset();
    speed_->setCurrentIndex(index);
    showMotionTexts();
}

QVector<HoldButton*> JogColumn::holdKeys() const {
    QVector<HoldButton*> keys;
    for (JogKey* key : pad_->keys()) {
        keys.append(key);
    }
    for (const JointRow* row : joints_->rows()) {
        keys << row->minusKey() << row->plusKey();
    }
    keys << freedrive_ << homeKey_ << align_ << back_;
    return keys;
}

void JogColumn::setHoldTerms(HoldTerms& terms) {
    for (HoldButton* key : holdKeys()) {
        key->guard().setTerms(terms);
    }
    axisJog_->setTerms(terms);
}

void JogColumn::stopMotion(StopCause cause) {
    for (HoldButton* key : holdKeys()) {
        key->guard().stop(cause);
    }
    axisJog_->stop(cause);
}

bool JogColumn::isHolding() const {
    for (const HoldButton* key : holdKeys()) {
        if (key->isHolding()) {
            return true;
        }
    }
    return axisJog_->isActive();
}

void JogColumn::applyState(const SessionState& state) {
    state_ = state;
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
    const bool stale = state.link != LinkState::Live;
    pose_->setPose(state.tcpPose, state.moving, valid, stale);
    joints_->setJoints(state.q, state.moving, valid, stale);
    for (HoldButton* key : holdKeys()) {
        key->setConfirmed(state.moving && key->isHolding());
    }
    showReason();
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
    back_->setUnavailable(!reason.isEmpty()                          ? reason
                          : track_->isEmpty() && !back_->isHolding() ? tr("The arm has not moved yet.")
                                                                     : QString());
    if (const QString last = countdown(); !last.isEmpty()) {
        limiter_->setLimiter({last, tr("let go and press again")});
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

void JogColumn::resizeEvent(QResizeEvent* event) {
    Panel::resizeEvent(event);
    const bool compact = height() < kCompactBelow;
    if (compact != compact_) {
        compact_ = compact;
        arrange();
    }
    const int key = !compact_ ? 72 : height() < kTightBelow ? 46 : 56;
    pad_->setMinimumHeight(3 * key + 2 * 8);
}

void JogColumn::arrange() {
    const bool jointsChosen = detailTab_->currentIndex() == 1;
    joints_->setCompact(compact_);
    detailTab_->setVisible(compact_);
    detailTab_->setFixedHeight(28);
    pose_->setVisible(!compact_ || !jointsChosen);
    joints_->setVisible(!compact_ || jointsChosen);
    for (SegmentedControl* control : {frame_, motion_, speed_}) {
        control->setFixedHeight(compact_ ? 30 : 38);
    }
    pad_->setMaximumHeight(compact_ ? QWIDGETSIZE_MAX : 3 * 72 + 2 * 8);
}

}  // namespace tiller
