// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/hold_guard.h"

#include <QApplication>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QWidget>
#include <utility>

namespace tiller {

using control::StopCause;

namespace {

// Marks every key that has a guard, so that a press on one can be kept from it while another is held.
constexpr char kHoldKeyProperty[] = "tillerHoldKey";

bool opensOverTheWindow(const QWidget& widget) {
    return widget.isWindow() && widget.windowType() != Qt::ToolTip &&
           widget.windowType() != Qt::SplashScreen && widget.windowType() != Qt::Desktop;
}

}  // namespace

HoldGuard::HoldGuard(QWidget& key, const Clock& clock) : key_(key), clock_(&clock) {
    key_.setProperty(kHoldKeyProperty, true);
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(kRefreshMs);
    connect(&timer_, &QTimer::timeout, this, &HoldGuard::pump);
    if (auto* app = qobject_cast<QGuiApplication*>(QCoreApplication::instance())) {
        connect(app, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
            if (state != Qt::ApplicationActive) {
                stop(StopCause::WindowDeactivated);
            }
        });
    }
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
    clock_ = &clock;
}

bool HoldGuard::press() {
    if (active_) {
        stop(StopCause::SecondButton);
        return false;
    }
    if (!key_.isEnabled() || !motion_.begin) {
        return false;
    }
    if (!key_.isActiveWindow()) {
        // The press that brings a window to the front is not meant for the arm.
        Q_EMIT refused({ErrorCode::Cancelled, tr("the window was not the active one; press again"), {}});
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
    active_ = true;
    pressed_ = true;
    lastPumpNs_ = clock_->nowNs();
    watch(true);
    timer_.start();
    Q_EMIT began();
    return true;
}

void HoldGuard::release() {
    pressed_ = false;
    if (!runsToEnd_) {
        stop(StopCause::Released);
    }
}

void HoldGuard::pointerMoved(const QPoint& position) {
    const QRect reach = key_.rect().adjusted(-kPointerSlack, -kPointerSlack, kPointerSlack, kPointerSlack);
    if (pressed_ && !reach.contains(position)) {
        stop(StopCause::PointerLeft);
    }
}

void HoldGuard::stop(StopCause cause) {
    if (!active_) {
        return;
    }
    active_ = false;
    pressed_ = false;
    timer_.stop();
    watch(false);
    if (motion_.end) {
        motion_.end(id_, cause);
    }
    Q_EMIT ended(cause);
}

void HoldGuard::pump() {
    if (!active_) {
        return;
    }
    const std::int64_t now = clock_->nowNs();
    if (now - lastPumpNs_ > kStallMs * kNsPerMs) {
        stop(StopCause::EventLoopStalled);
        return;
    }
    lastPumpNs_ = now;
    if (motion_.hold && !motion_.hold(id_) && active_) {
        active_ = false;
        pressed_ = false;
        timer_.stop();
        watch(false);
        Q_EMIT ended(StopCause::None);
    }
}

void HoldGuard::watch(bool on) {
    if (on) {
        qApp->installEventFilter(this);
    } else {
        qApp->removeEventFilter(this);
    }
}

bool HoldGuard::eventFilter(QObject* watched, QEvent* event) {
    if (!active_) {
        return false;
    }
    switch (event->type()) {
        case QEvent::ShortcutOverride:
        case QEvent::KeyPress:
            return filterKey(event);
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
        case QEvent::NonClientAreaMouseButtonPress:
        case QEvent::TouchBegin:
        case QEvent::TabletPress:
            return filterSecondPress(watched, event);
        case QEvent::ApplicationDeactivate:
        case QEvent::Quit:
            stop(StopCause::WindowDeactivated);
            return false;
        default:
            break;
    }
    if (watched == &key_) {
        filterOwnKey(event);
    }
    if (active_ && watched->isWidgetType()) {
        filterWindow(watched, event);
    }
    return false;
}

bool HoldGuard::filterKey(QEvent* event) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->isAutoRepeat()) {
        return false;
    }
    if (key->key() == Qt::Key_Escape) {
        stop(StopCause::Escape);
    } else if (key->key() == Qt::Key_Space) {
        stop(StopCause::Space);
    }
    return false;  // the window's own stop keys see it as well
}

bool HoldGuard::filterSecondPress(QObject* watched, QEvent*) {
    // A press passes the native window first and the widget then: decide at the widget, which may be a key.
    if (watched->inherits("QWidgetWindow")) {
        return false;
    }
    stop(StopCause::SecondButton);
    return isHoldKey(*watched);
}

void HoldGuard::filterOwnKey(QEvent* event) {
    // A window that is being hidden loses focus and activity first: name the real reason.
    const bool windowGone = key_.window()->isHidden();
    const StopCause whyGone = windowGone ? StopCause::WindowClosed : StopCause::SelectionChanged;
    switch (event->type()) {
        case QEvent::FocusOut: {
            const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
            if (!key_.isEnabled()) {
                stop(StopCause::ControlLost);
            } else if (windowGone || !key_.isVisible()) {
                stop(whyGone);
            } else if (reason == Qt::PopupFocusReason || reason == Qt::MenuBarFocusReason) {
                stop(StopCause::DialogOpened);
            } else if (reason == Qt::ActiveWindowFocusReason) {
                stop(StopCause::WindowDeactivated);
            } else {
                stop(StopCause::FocusLost);
            }
            break;
        }
        case QEvent::Hide:
            stop(whyGone);
            break;
        case QEvent::EnabledChange:
            if (!key_.isEnabled()) {
                stop(StopCause::ControlLost);
            }
            break;
        case QEvent::TouchCancel:
            stop(StopCause::DeviceLost);
            break;
        case QEvent::ParentChange:
            stop(StopCause::WindowClosed);
            break;
        default:
            break;
    }
}

void HoldGuard::filterWindow(QObject* watched, QEvent* event) {
    const auto& widget = *static_cast<QWidget*>(watched);
    if (watched != key_.window()) {
        if (event->type() == QEvent::Show && !event->spontaneous() && opensOverTheWindow(widget)) {
            stop(StopCause::DialogOpened);
        }
        return;
    }
    switch (event->type()) {
        case QEvent::WindowDeactivate:
            stop(widget.isHidden() ? StopCause::WindowClosed : StopCause::WindowDeactivated);
            break;
        case QEvent::WindowBlocked:
            stop(StopCause::DialogOpened);
            break;
        case QEvent::WindowStateChange:
            if (widget.isMinimized()) {
                stop(StopCause::WindowDeactivated);
            }
            break;
        case QEvent::Hide:
        case QEvent::Close:
            stop(StopCause::WindowClosed);
            break;
        default:
            break;
    }
}

}  // namespace tiller
