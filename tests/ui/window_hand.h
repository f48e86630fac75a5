// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One mouse and one keyboard in front of windows. What they do takes the way of the window system: a window
// behind a dialog hears nothing, a menu takes the click, shortcuts go before fields.

#include <QList>
#include <QPoint>
#include <QPointer>
#include <QString>
#include <QWidget>
#include <utility>

namespace tiller::test {

class WindowHand {
public:
    /// home  a window that outlives the hand: it hears of a release whose own window is gone
    explicit WindowHand(QWidget& home) : home_(home) {}

    // at  in the window [px]
    void press(QWidget& window, QPoint at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = {});
    void release(Qt::MouseButton button);
    void click(QWidget& window, QPoint at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = {});
    void doubleClick(QWidget& window, QPoint at, Qt::MouseButton button);
    void moveTo(QWidget& window, QPoint at);
    /// notches  away from the hand; below 0 towards it
    void wheel(QWidget& window, QPoint at, int notches, Qt::KeyboardModifiers modifiers = {});

    // Keys go to the window that has the keyboard; to nobody while none has it.
    void keyDown(Qt::Key key, Qt::KeyboardModifiers modifiers = {}, const QString& text = {});
    void keyUp();  ///< The one that went down last.
    void keyClick(Qt::Key key, Qt::KeyboardModifiers modifiers = {}, const QString& text = {});
    void type(const QString& text);

    bool holdsButton() const { return buttons_ != Qt::NoButton; }
    bool holdsKey() const { return !keys_.isEmpty(); }
    /// Of all buttons and keys.
    void letGo();

private:
    struct HeldKey {
        Qt::Key key;
        Qt::KeyboardModifiers modifiers;
        QString text;
    };
    static QPoint inside(const QWindow& window, QPoint at);
    /// Where the mouse is: its window, or home when that has gone, and the place in there.
    std::pair<QWindow*, QPoint> under() const;
    void goTo(QWidget& window, QPoint at);
    void sendModifiers(bool pressed, Qt::KeyboardModifiers modifiers) const;

    QWidget& home_;
    QPointer<QWidget> window_;  ///< where the mouse is
    QPoint at_;                 ///< in the window [px]
    QPoint global_;             ///< on the screen [px]
    Qt::MouseButtons buttons_ = Qt::NoButton;
    QList<HeldKey> keys_;
};

}  // namespace tiller::test
