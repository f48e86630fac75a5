// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/hold/hold_guard.h"

#include <QWidget>
#include <utility>

namespace tiller {

using control::StopCause;

namespace {

// Property of buttons with a guard. While another hold-to-run button is held, a press on such a button is
// discarded.
constexpr char kHoldKeyProperty[] = "tillerHoldKey";

}  // namespace

HoldGuard::HoldGuard(QWidget& key, HoldPolicy& policy, const Clock& clock)
    : key_(key)
    , rules_(
          policy, [this](StopCause cause) { stop(cause); }, clock)
    , clock_(&clock) {
    key_.setProperty(kHoldKeyProperty, true);
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(kRefreshMs);
    connect(&timer_, &QTimer::timeout, this, &HoldGuard::pump);
}

HoldGuard::~HoldGuard() {
    stop(StopCause::WindowClosed);
}

bool HoldGuard::isHoldKey(const QObject& widget) {
    return widget.property(kHoldKeyProperty).toBool();
}

void HoldGuard::setMotion(HoldMotion motion) {
    stop(StopCause::SelectionChanged);
    motion_ = std::move(motion);
}

void HoldGuard::setClock(const Clock& clock) {
    stop(StopCause::SelectionChanged);
    rules_.setClock(clock);
    clock_ = &clock;
}

bool HoldGuard::press(const HoldSource& grip) {
    if (active()) {
        rules_.happen(HoldEvent::Kind::PressedAgain);
        return false;
    }
    if (!key_.isEnabled() || !motion_.begin) {
        return false;
    }
    if (const QString why = rules_.obstacle(&key_, grip); !why.isEmpty()) {
        rules_.endOther();  // rule: a button is pressed while another input holds a motion
        Q_EMIT refused({ErrorCode::Cancelled, why, {}});
        return false;
    }
    key_.setFocus(Qt::MouseFocusReason);
    runsToEnd_ = motion_.runsToEnd && motion_.runsToEnd();
    const Result<HoldMotion::Id> motion = motion_.begin();
    if (!motion) {
        Q_EMIT refused(motion.error());
        return false;
    }
    id_ = motion.value();
    pressed_ = true;
    const HoldBounds bounds = motion_.bounds ? motion_.bounds() : HoldBounds();
    hasEnd_ = bounds.longestNs > 0 && !runsToEnd_;
    pauses_ = false;
    beganNs_ = clock_->nowNs();
    // A short step runs to its end even if the button is released.
    rules_.begin(&key_, runsToEnd_ ? HoldSource{HoldSource::By::Nobody} : grip, bounds);
    timer_.start();
    Q_EMIT began();
    // The start of the motion may have disabled the button, which then receives no release. The rules have
    // not detected this, because they were not active yet.
    if (!key_.isEnabled()) {
        stop(StopCause::ControlLost);
    }
    return active();
}

void HoldGuard::release() {
    pressed_ = false;
    if (!runsToEnd_) {
        rules_.happen(HoldEvent::Kind::LetGo);
    }
}

void HoldGuard::pointerMoved(const QPoint& position) {
    if (!pressed_) {
        return;
    }
    rules_.heard();
    HoldEvent news{HoldEvent::Kind::PointerAt};
    news.position = position;
    rules_.happen(news);
}

void HoldGuard::finish() {
    rules_.end();
    pressed_ = false;
    timer_.stop();
}

void HoldGuard::stop(StopCause cause) {
    if (!active()) {
        return;
    }
    finish();
    if (motion_.end) {
        motion_.end(id_, cause);
    }
    Q_EMIT ended(cause);
    if (cause == StopCause::Released && hasEnd_ && clock_->nowNs() - beganNs_ < kClickNs) {
        Q_EMIT clicked();
    }
}

void HoldGuard::pump() {
    if (active() && motion_.pause && !pauses_ && rules_.isNearLimit()) {
        pauses_ = true;
        rules_.extend(motion_.pause());
    }
    if (!active() || rules_.happen(HoldEvent::Kind::Refresh)) {
        return;
    }
    if (motion_.hold && !motion_.hold(id_) && active()) {
        finish();
        Q_EMIT ended(StopCause::None);
    }
}

}  // namespace tiller

#include "moc_hold_guard.cpp"
