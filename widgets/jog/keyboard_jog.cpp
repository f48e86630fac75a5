// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/jog/keyboard_jog.h"

#include <QApplication>
#include <QFrame>
#include <QKeyEvent>
#include <QWindow>
#include <algorithm>
#include <array>
#include <utility>

#include "widgets/common/text_entry.h"
#include "widgets/common/theme.h"

namespace tiller {

namespace {

/// Flag for an arrow key that selects rotation.
constexpr int kTurns = 0x4000'0000;

constexpr Qt::KeyboardModifiers kMeaningful = Qt::ShiftModifier | Qt::ControlModifier | Qt::AltModifier;

bool isModifier(int key) {
    switch (key) {
        case Qt::Key_Shift:
        case Qt::Key_Control:
        case Qt::Key_Alt:
        case Qt::Key_Meta:  // reported for Alt while Shift is held
        case Qt::Key_AltGr:
            return true;
        default:
            return false;
    }
}

/// The arrow and page keys for X, Y and Z: positive direction, then negative direction.
constexpr std::array<std::pair<int, int>, 3> kOpposites = {
    {{Qt::Key_Right, Qt::Key_Left}, {Qt::Key_Up, Qt::Key_Down}, {Qt::Key_PageUp, Qt::Key_PageDown}}};

bool isArrow(int meaning) {
    switch (meaning & ~kTurns) {
        case Qt::Key_Left:
        case Qt::Key_Right:
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_PageUp:
        case Qt::Key_PageDown:
            return true;
        default:
            return false;
    }
}

bool isJointKey(int meaning) {
    return (meaning >= Qt::Key_1 && meaning <= Qt::Key_6) || meaning == Qt::Key_Plus ||
           meaning == Qt::Key_Minus;
}

/// Returns the meaning of a key according to the symbol at the press. "=" without Shift counts as "+", and
/// "_" with Shift counts as "-", as on a US keyboard. Keys of other layouts that produce "=" with Shift or
/// "_" without Shift have no meaning.
int meaningOf(const QKeyEvent& event) {
    const bool shift = event.modifiers().testFlag(Qt::ShiftModifier);
    if (event.key() == Qt::Key_Equal && !shift) {
        return Qt::Key_Plus;
    }
    return event.key() == Qt::Key_Underscore && shift ? static_cast<int>(Qt::Key_Minus)
                                                      : PhysicalKeys::keyOf(event);
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

bool KeyboardJog::isJogKey(int meaning) const {
    return isArrow(meaning) || isJointKey(meaning) || holdKeys_.contains(meaning);
}

void KeyboardJog::addHoldKey(Qt::Key key, HoldGuard& guard) {
    holdKeys_[key] = &guard;
}

/// True if a text field, a menu, a dialog or another window handles keyboard input.
bool KeyboardJog::belongsElsewhere() const {
    return !window_.isActiveWindow() || takesText(QApplication::focusWidget()) ||
           QApplication::activePopupWidget() != nullptr || QApplication::activeModalWidget() != nullptr;
}

/// True while a motion is held by keyboard keys.
bool KeyboardJog::isMoving() const {
    if (keys_.isEmpty()) {
        return false;
    }
    return jog_.isActive() || (step_ && step_->active()) ||
           std::any_of(holdKeys_.begin(), holdKeys_.end(),
                       [](const HoldGuard* guard) { return guard->active(); });
}

/// Ends the motion held by keys because of a keyboard event. The keys remain registered, so that their
/// releases match. They have no effect until all are released.
void KeyboardJog::tell(HoldEvent::Kind kind) {
    for (HoldGuard* guard : std::as_const(holdKeys_)) {
        guard->tell(kind);
    }
    if (step_) {
        step_->tell(kind);
    }
    jog_.tell(kind);
    jog_.requireNeutral(HoldSource::By::Keys);  // rule: release all keys first
}

/// Ends the motion held by keys and clears all pressed keys, because their releases in another window would
/// not be received.
void KeyboardJog::forget(control::StopCause cause) {
    for (HoldGuard* guard : std::as_const(holdKeys_)) {
        guard->stop(cause);
    }
    if (step_) {
        step_->stop(cause);
    }
    keys_.clear();
    jog_.stop(cause);
    jog_.setInput({});
}

void KeyboardJog::setLock(const QString& why) {
    lock_ = why;
    if (!lock_.isEmpty()) {
        setArmed(false);
    }
}

void KeyboardJog::setArmed(bool armed) {
    if (armed == armed_) {
        return;
    }
    const QString why = lock_.isEmpty() && !jog_.isActive() ? jog_.obstacle() : lock_;
    if (armed && !why.isEmpty()) {
        Q_EMIT refused(why);
        return;
    }
    armed_ = armed;
    keys_.clear();
    if (armed) {
        if (takesText(window_.focusWidget())) {
            window_.setFocus();
        }
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
        forget(control::StopCause::SelectionChanged);
        delete frame_;
    }
    Q_EMIT armedChanged(armed);
}

void KeyboardJog::followControl(bool isInControl) {
    if (armed_ && !isInControl && !isMoving()) {
        setArmed(false);
    }
}

void KeyboardJog::followWindow() {
    if (frame_) {
        frame_->setGeometry(window_.rect());
    }
}

void KeyboardJog::checkIdle() {
    if (armed_ && keys_.isEmpty() && clock_->nowNs() - lastKeyNs_ > kIdleSeconds * kNsPerSecond) {
        setArmed(false);
    }
}

bool KeyboardJog::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::KeyPress:
        case QEvent::KeyRelease:
            return watched->isWidgetType() && keyEvent(*static_cast<QKeyEvent*>(event));
        case QEvent::ShortcutOverride: {
            // In armed mode, jog keys are not available as shortcuts.
            const auto& key = *static_cast<QKeyEvent*>(event);
            if ((isJogKey(meaningOf(key)) || keys_.isDown(PhysicalKeys::codeOf(key))) &&
                !belongsElsewhere()) {
                event->accept();
                return true;
            }
            return false;
        }
        case QEvent::FocusIn:
            if (const auto* field = qobject_cast<QWidget*>(watched);
                takesText(field) && field->window() == &window_) {
                forget(control::StopCause::FocusLost);
                setArmed(false);
                Q_EMIT fieldFocused();
            }
            return false;
        case QEvent::Resize:
            if (watched == &window_) {
                followWindow();
            }
            return false;
        case QEvent::FocusOut:  // the focus may move to a floating panel while the window remains active
        case QEvent::WindowDeactivate:
            if (watched == (event->type() == QEvent::FocusOut ? static_cast<QObject*>(window_.windowHandle())
                                                              : &window_)) {
                // Disarm the keyboard, because it may be armed only while the window is active.
                forget(control::StopCause::WindowDeactivated);
                setArmed(false);
            }
            return false;
        default:
            return false;
    }
}

bool KeyboardJog::keyEvent(const QKeyEvent& event) {
    if (isModifier(event.key())) {
        if (!event.isAutoRepeat()) {
            modifierChanged();
        }
        // In armed mode, Alt selects rotation instead of opening the menu.
        return event.key() == Qt::Key_Alt && !belongsElsewhere();
    }
    const KeyCode code = PhysicalKeys::codeOf(event);
    const bool known = keys_.isDown(code);
    const bool press = event.type() == QEvent::KeyPress;
    int meaning = known ? keys_.meaningOf(code) : meaningOf(event);
    // Process the release of a registered key regardless of the focus.
    if (!known && !press) {
        // Release without a press. If the key code is unknown, it may be the release of a motion key.
        if (!event.isAutoRepeat() && isMoving() && (isJogKey(meaning) || !PhysicalKeys::hasNumber(code))) {
            tell(HoldEvent::Kind::Unmatched);  // rule: release of a key that was not down
        }
        return false;
    }
    if (press && (belongsElsewhere() || (!known && !isJogKey(meaning)))) {
        return false;
    }
    if (isArrow(meaning) && !known && event.modifiers().testFlag(Qt::AltModifier)) {
        meaning |= kTurns;
    }
    lastKeyNs_ = clock_->nowNs();
    switch (keys_.take(event, meaning)) {
        case PhysicalKeys::Change::Down:
            if (HoldGuard* guard = holdKeys_.value(meaning)) {
                holdKeyPressed(*guard, code);
            } else {
                jogKeyPressed(event);
            }
            break;
        case PhysicalKeys::Change::Up:
            keyReleased(meaning);
            break;
        case PhysicalKeys::Change::DownAgain:
            tell(HoldEvent::Kind::Unmatched);  // rule: press of a key that is down
            break;
        case PhysicalKeys::Change::Repeat:
        case PhysicalKeys::Change::Unknown:
            break;
    }
    return true;
}

void KeyboardJog::jogKeyPressed(const QKeyEvent& event) {
    const Qt::KeyboardModifiers modifiers = event.modifiers() & kMeaningful;
    const bool held = std::any_of(holdKeys_.begin(), holdKeys_.end(),
                                  [](const HoldGuard* guard) { return guard->active(); });
    if (held) {
        tell(HoldEvent::Kind::OtherKey);  // rule: a jog key in addition to a hold key
    } else if (makesSteps()) {
        stepKeyPressed();
    } else if (jog_.isActive() && modifiers != modifiers_) {
        tell(HoldEvent::Kind::Modifier);  // rule: the modifiers differ from those at the start
    } else {
        modifiers_ = modifiers;
        follow();
    }
}

void KeyboardJog::stepKeyPressed() {
    jog_.requireNeutral(HoldSource::By::Keys);
    const Deflection wish = deflection();
    if (HoldGuard* button = steps_.button(wish)) {
        step_ = button;
        button->press({HoldSource::By::Keys, keys_.codes()});
    } else if (!wish.isNeutral()) {
        tell(HoldEvent::Kind::OtherKey);  // rule: a step has one direction
    }
}

void KeyboardJog::holdKeyPressed(HoldGuard& guard, KeyCode code) {
    // Only one motion is permitted at a time. The second key stops the first motion and starts no motion.
    if (isMoving()) {
        tell(HoldEvent::Kind::OtherKey);  // rule: a hold key in addition to another motion
    } else {
        guard.press({HoldSource::By::Keys, {code}});
    }
}

void KeyboardJog::keyReleased(int meaning) {
    if (HoldGuard* guard = holdKeys_.value(meaning)) {
        guard->release();
    }
    if (step_) {
        step_->release();
    }
    follow();
}

void KeyboardJog::modifierChanged() {
    if (isMoving()) {
        tell(HoldEvent::Kind::Modifier);  // rule: a modifier is pressed or released
    }
}

/// Sends the input of the held keys to AxisJog.
void KeyboardJog::follow() {
    if (makesSteps()) {
        if (keys_.isEmpty()) {
            jog_.setInput({});
        }
        return;
    }
    const auto both = [this](int one, int other) { return keys_.means(one) && keys_.means(other); };
    bool opposite = both(Qt::Key_Plus, Qt::Key_Minus);
    for (const auto& [one, other] : kOpposites) {
        opposite = opposite || both(one, other) || both(one | kTurns, other | kTurns);
    }
    Deflection wish = deflection();
    wish.grip = {HoldSource::By::Keys, keys_.codes()};
    // Reject opposite keys, and joints together with Cartesian axes. The remaining key must not start a
    // motion when the other key is released.
    if (opposite || (!wish.axes.isZero() && !wish.joints.isZero())) {
        tell(HoldEvent::Kind::OtherKey);  // rule: opposite keys
        return;
    }
    // Ignore Shift for joint keys, because some layouts need Shift for digits and signs.
    const bool joints = wish.axes.isZero();
    jog_.setInput(wish, modifierFactor(joints ? modifiers_ & ~Qt::ShiftModifier : modifiers_));
}

Deflection KeyboardJog::deflection() const {
    const auto pair = [this](int plus, int minus) {
        return (keys_.means(plus) ? 1.0 : 0.0) - (keys_.means(minus) ? 1.0 : 0.0);
    };
    Deflection wish;
    wish.deadMan = true;  // a held key is also the enabling signal
    for (int axis = 0; axis < 3; ++axis) {
        const auto& [plus, minus] = kOpposites.at(static_cast<std::size_t>(axis));
        wish.axes[axis] = pair(plus, minus);
        wish.axes[axis + 3] = pair(plus | kTurns, minus | kTurns);
    }
    const double direction = pair(Qt::Key_Plus, Qt::Key_Minus);
    for (int joint = 0; joint < kJointCount; ++joint) {
        wish.joints[joint] = keys_.means(Qt::Key_1 + joint) ? direction : 0.0;
    }
    return wish;
}

}  // namespace tiller

#include "moc_keyboard_jog.cpp"
