// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_hand.h"

#include <QApplication>
#include <QTest>
#include <QWheelEvent>
#include <QWindow>
#include <algorithm>
#include <utility>

namespace tiller::test {

namespace {

/// Returns the focus window. The offscreen platform sometimes returns a destroyed window.
QWindow* focusWindow() {
    QWindow* window = QGuiApplication::focusWindow();
    return QGuiApplication::allWindows().contains(window) ? window : nullptr;
}

}  // namespace

// Qt Test uses (0, 0) for the centre and prints a warning for positions outside the window.
QPoint WindowHand::inside(const QWindow& window, QPoint at) {
    const QSize size = window.geometry().size();
    return {std::clamp(at.x(), 1, std::max(1, size.width() - 1)),
            std::clamp(at.y(), 1, std::max(1, size.height() - 1))};
}

std::pair<QWindow*, QPoint> WindowHand::under() const {
    QWindow* own = window_ != nullptr && window_->isVisible() ? window_->windowHandle() : nullptr;
    return own != nullptr ? std::pair(own, at_)
                          : std::pair(home_.windowHandle(), home_.mapFromGlobal(global_));
}

void WindowHand::goTo(QWidget& window, QPoint at) {
    window_ = &window;
    at_ = at;
    global_ = window.mapToGlobal(at);
}

void WindowHand::press(QWidget& window, QPoint at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    goTo(window, at);
    buttons_ |= button;
    if (const auto [to, place] = under(); to != nullptr) {
        QTest::mousePress(to, button, modifiers, inside(*to, place));
    }
}

void WindowHand::release(Qt::MouseButton button) {
    if (!buttons_.testFlag(button)) {
        return;
    }
    buttons_ &= ~Qt::MouseButtons(button);
    if (const auto [to, place] = under(); to != nullptr) {
        QTest::mouseRelease(to, button, {}, inside(*to, place));
    }
}

void WindowHand::click(QWidget& window, QPoint at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    press(window, at, button, modifiers);
    release(button);
}

void WindowHand::doubleClick(QWidget& window, QPoint at, Qt::MouseButton button) {
    goTo(window, at);
    // The second press must follow within the double-click interval. Qt Test would separate two clicks sent
    // by press().
    if (const auto [to, place] = under(); to != nullptr) {
        QTest::mouseDClick(to, button, {}, inside(*to, place));
    }
}

void WindowHand::moveTo(QWidget& window, QPoint at) {
    if (holdsButton() && window_ != nullptr && window_ != &window) {
        // A pressed button keeps the mouse grabbed by its window.
        goTo(*window_, window_->mapFromGlobal(window.mapToGlobal(at)));
    } else {
        goTo(window, at);
    }
    if (const auto [to, place] = under(); to != nullptr) {
        QTest::mouseMove(to, inside(*to, place));
    }
}

void WindowHand::wheel(QWidget& window, QPoint at, int notches, Qt::KeyboardModifiers modifiers) {
    QWidget* modal = QApplication::activeModalWidget();
    QWidget* popup = QApplication::activePopupWidget();
    if ((modal != nullptr && modal->window() != &window) || (popup != nullptr && popup != &window)) {
        return;  // the window system would not deliver the event
    }
    QWidget* under = window.childAt(at);
    if (under == nullptr) {
        under = &window;
    }
    constexpr int kNotch = 120;  // unit of Qt, in eighths of a degree
    QWheelEvent event(QPointF(under->mapFrom(&window, at)), QPointF(window.mapToGlobal(at)), QPoint(),
                      QPoint(0, kNotch * notches), buttons_, modifiers, Qt::NoScrollPhase, false);
    QSpontaneKeyEvent::setSpontaneous(&event);
    qApp->notify(under, &event);
}

void WindowHand::keyDown(Qt::Key key, Qt::KeyboardModifiers modifiers, const QString& text) {
    if (focusWindow() == nullptr) {
        return;
    }
    keys_.append({key, modifiers, text});
    sendModifiers(true, modifiers);
    // Alt may have closed the menu that had the focus.
    if (QWindow* to = focusWindow()) {
        QTest::simulateEvent(to, true, key, modifiers, text, false);
    }
}

void WindowHand::sendModifiers(bool pressed, Qt::KeyboardModifiers modifiers) const {
    for (const auto& [modifier, key] : {std::pair{Qt::ShiftModifier, Qt::Key_Shift},
                                        {Qt::ControlModifier, Qt::Key_Control},
                                        {Qt::AltModifier, Qt::Key_Alt},
                                        {Qt::MetaModifier, Qt::Key_Meta}}) {
        QWindow* to = focusWindow();
        to = to != nullptr ? to : home_.windowHandle();
        if (to != nullptr && modifiers.testFlag(modifier)) {
            QTest::simulateEvent(to, pressed, key, pressed ? Qt::KeyboardModifiers(modifier) : Qt::NoModifier,
                                 QString(), false);
        }
    }
}

void WindowHand::keyUp() {
    if (keys_.isEmpty()) {
        return;
    }
    const HeldKey held = keys_.takeLast();
    QWindow* to = focusWindow();
    to = to != nullptr ? to : home_.windowHandle();
    if (to != nullptr) {
        QTest::simulateEvent(to, false, held.key, held.modifiers, held.text, false);
    }
    sendModifiers(false, held.modifiers);
}

void WindowHand::keyClick(Qt::Key key, Qt::KeyboardModifiers modifiers, const QString& text) {
    const qsizetype held = keys_.size();
    keyDown(key, modifiers, text);
    if (keys_.size() > held) {
        keyUp();
    }
}

void WindowHand::type(const QString& text) {
    for (const QChar letter : text) {
        keyClick(static_cast<Qt::Key>(letter.toUpper().unicode()), {}, QString(letter));
    }
}

void WindowHand::letGo() {
    for (const Qt::MouseButton button : {Qt::LeftButton, Qt::RightButton, Qt::MiddleButton}) {
        release(button);
    }
    while (holdsKey()) {
        keyUp();
    }
}

}  // namespace tiller::test
