// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A mouse and a keyboard for windows. Events are delivered as by the window system: a window behind a modal
// dialog receives nothing, a menu receives the click, and shortcuts have priority over fields.

#include <QList>
#include <QPoint>
#include <QPointer>
#include <QString>
#include <QWidget>
#include <utility>

namespace tiller::test {

class WindowHand {
public:
    /// home  a window that outlives the object; it receives a release if the pressed window was destroyed
    explicit WindowHand(QWidget& home) : home_(home) {}

    // at  position in the window [px]
    void press(QWidget& window, QPoint at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = {});
    void release(Qt::MouseButton button);
    void click(QWidget& window, QPoint at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = {});
    void doubleClick(QWidget& window, QPoint at, Qt::MouseButton button);
    void moveTo(QWidget& window, QPoint at);
    /// notches  positive away from the user, negative towards the user
    void wheel(QWidget& window, QPoint at, int notches, Qt::KeyboardModifiers modifiers = {});

    // Keys are sent to the window with the keyboard focus, if there is one.
    void keyDown(Qt::Key key, Qt::KeyboardModifiers modifiers = {}, const QString& text = {});
    void keyUp();  ///< releases the most recently pressed key
    void keyClick(Qt::Key key, Qt::KeyboardModifiers modifiers = {}, const QString& text = {});
    void type(const QString& text);

    bool holdsButton() const { return buttons_ != Qt::NoButton; }
    bool holdsKey() const { return !keys_.isEmpty(); }
    /// Releases all buttons and keys.
    void letGo();

private:
    struct HeldKey {
        Qt::Key key;
        Qt::KeyboardModifiers modifiers;
        QString text;
    };
    static QPoint inside(const QWindow& window, QPoint at);
    /// The window under the mouse, or home if that window was destroyed, and the mouse position in the
    /// window.
    std::pair<QWindow*, QPoint> under() const;
    void goTo(QWidget& window, QPoint at);
    void sendModifiers(bool pressed, Qt::KeyboardModifiers modifiers) const;

    QWidget& home_;
    QPointer<QWidget> window_;  ///< the window under the mouse
    QPoint at_;                 ///< position in the window [px]
    QPoint global_;             ///< position on the screen [px]
    Qt::MouseButtons buttons_ = Qt::NoButton;
    QList<HeldKey> keys_;
};

}  // namespace tiller::test
