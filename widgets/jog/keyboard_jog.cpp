// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/keyboard_jog.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QFrame>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextEdit>

#include "widgets/common/theme.h"

namespace tiller {

namespace {

bool takesText(const QWidget* widget) {
    const auto* line = qobject_cast<const QLineEdit*>(widget);
    return (line != nullptr && !line->isReadOnly()) || qobject_cast<const QTextEdit*>(widget) != nullptr ||
           qobject_cast<const QPlainTextEdit*>(widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(widget) != nullptr;
}

/// The signs without the shift key too, which some layouts need for them.
int plain(int key) {
    return key == Qt::Key_Equal ? Qt::Key_Plus : key == Qt::Key_Underscore ? Qt::Key_Minus : key;
}

}  // namespace

KeyboardJog::KeyboardJog(AxisJog& jog, QWidget& window, QObject* parent)
    : QObject(parent), jog_(jog), window_(window) {
    idle_.setInterval(1000);
    connect(&idle_, &QTimer::timeout, this, &KeyboardJog::checkIdle);
}

KeyboardJog::~KeyboardJog() {
    setArmed(false);
}

bool KeyboardJog::isJogKey(int key) const {
    switch (key) {
        case Qt::Key_Left:
        case Qt::Key_Right:
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_PageUp:
        case Qt::Key_PageDown:
        case Qt::Key_Alt:
        case Qt::Key_Plus:
        case Qt::Key_Minus:
            return true;
        default:
            return (key >= Qt::Key_1 && key <= Qt::Key_6) || holdKeys_.contains(key);
    }
}

void KeyboardJog::addHoldKey(Qt::Key key, HoldGuard& guard) {
    holdKeys_[key] = &guard;
}

void KeyboardJog::letGo(control::StopCause cause) {
    // Releases that happen elsewhere are never seen: nothing counts as held any more.
    down_.clear();
    for (HoldGuard* guard : std::as_const(holdKeys_)) {
        guard->stop(cause);
    }
    jog_.stop(cause);
    jog_.setInput({});
}

void KeyboardJog::setArmed(bool armed) {
    if (armed == armed_) {
        return;
    }
    armed_ = armed;
    down_.clear();
    if (armed) {
        lastKeyNs_ = clock_->nowNs();
        qApp->installEventFilter(this);
        idle_.start();
        frame_ = new QFrame(&window_);
        frame_->setObjectName(QStringLiteral("armedFrame"));
        frame_->setAccessibleName(tr("Keyboard jogging is armed"));
        frame_->setAttribute(Qt::WA_TransparentForMouseEvents);
        frame_->setStyleSheet(
            QStringLiteral("QFrame#armedFrame { border: 5px solid %1; background: transparent; }")
                .arg(Theme::current().operatorNeeded.name()));
        followWindow();
        frame_->show();
        frame_->raise();
    } else {
        qApp->removeEventFilter(this);
        idle_.stop();
        letGo(control::StopCause::SelectionChanged);
        delete frame_;
    }
    Q_EMIT armedChanged(armed);
}

void KeyboardJog::followWindow() {
    if (frame_) {
        frame_->setGeometry(window_.rect());
    }
}

void KeyboardJog::checkIdle() {
    if (armed_ && down_.isEmpty() && clock_->nowNs() - lastKeyNs_ > kIdleSeconds * kNsPerSecond) {
        setArmed(false);
    }
}

bool KeyboardJog::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::KeyPress:
        case QEvent::KeyRelease:
            return watched->isWidgetType() && keyEvent(event);
        case QEvent::ShortcutOverride: {
            // An armed key is no shortcut.
            const auto* key = static_cast<QKeyEvent*>(event);
            if (isJogKey(plain(key->key())) && !takesText(QApplication::focusWidget())) {
                event->accept();
                return true;
            }
            return false;
        }
        case QEvent::FocusIn:
            // From here on the keys write: what they held is let go.
            if (!down_.isEmpty() && takesText(qobject_cast<QWidget*>(watched))) {
                letGo(control::StopCause::FocusLost);
            }
            return false;
        case QEvent::Resize:
            if (watched == &window_) {
                followWindow();
            }
            return false;
        case QEvent::WindowDeactivate:
            if (watched == &window_) {
                // What is armed stays armed only while the operator looks at it.
                letGo(control::StopCause::WindowDeactivated);
                setArmed(false);
            }
            return false;
        default:
            return false;
    }
}

bool KeyboardJog::keyEvent(QEvent* event) {
    const auto* key = static_cast<QKeyEvent*>(event);
    const int code = plain(key->key());
    const bool press = event->type() == QEvent::KeyPress;
    const bool known = down_.contains(code);
    // A key that was pressed here is let go here, wherever the focus is by then.
    const bool elsewhere = !window_.isActiveWindow() || takesText(QApplication::focusWidget());
    if (!isJogKey(code) || (elsewhere && !(known && !press))) {
        return false;
    }
    if (key->isAutoRepeat()) {
        return true;
    }
    lastKeyNs_ = clock_->nowNs();
    if (press) {
        down_.insert(code);
    } else {
        down_.remove(code);
    }
    if (HoldGuard* guard = holdKeys_.value(code)) {
        if (known != press) {
            holdEvent(*guard, press);
        }
        return true;
    }
    // Some systems send one event to several widgets: the second of the same kind changes nothing.
    if (known != press || !press) {
        // Shift may only be how "+" is written.
        const bool sign = down_.contains(Qt::Key_Plus) || down_.contains(Qt::Key_Minus);
        jog_.setInput(deflection(),
                      modifierFactor(sign ? key->modifiers() & ~Qt::ShiftModifier : key->modifiers()));
    }
    return true;
}

void KeyboardJog::holdEvent(HoldGuard& guard, bool press) {
    if (!press) {
        guard.release();
        return;
    }
    // One motion at a time: the second key stops the first and begins nothing.
    bool another = jog_.isActive();
    for (const HoldGuard* other : std::as_const(holdKeys_)) {
        another = another || other->active();
    }
    if (another) {
        letGo(control::StopCause::SecondButton);
    } else {
        guard.press();
    }
}

Deflection KeyboardJog::deflection() const {
    const auto pair = [this](int plus, int minus) {
        return (down_.contains(plus) ? 1.0 : 0.0) - (down_.contains(minus) ? 1.0 : 0.0);
    };
    Deflection wish;
    wish.deadMan = true;  // the key itself, while it is held
    const int first = down_.contains(Qt::Key_Alt) ? 3 : 0;
    wish.axes[first] = pair(Qt::Key_Right, Qt::Key_Left);
    wish.axes[first + 1] = pair(Qt::Key_Up, Qt::Key_Down);
    wish.axes[first + 2] = pair(Qt::Key_PageUp, Qt::Key_PageDown);
    const double direction = pair(Qt::Key_Plus, Qt::Key_Minus);
    for (int joint = 0; joint < kJointCount; ++joint) {
        wish.joints[joint] = down_.contains(Qt::Key_1 + joint) ? direction : 0.0;
    }
    return wish;
}

}  // namespace tiller
