// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Checks that nothing moves under the pointer: for half a second after a click, no control near the pointer moves
// and none moves there. A second click must not hit another control.
//
// The rule in detail:
// - All controls (buttons, fields, sliders, boxes, chips) of the clicked window are checked that were visible and
//   enabled just before the press.
// - A control has moved if its position or size in the window differs from before the press.
// - It counts if its old position was visible within 40 px of the pointer, or if its new one is. Controls that
//   disappear or appear have not moved.
// - Effects of the click itself are allowed: the watch ends when the clicked window closes, or when a dialog or
//   menu opens or closes. A click on a button that folds, scrolls, filters or resizes its surroundings allows
//   changes in this part of the window only; see the list in containerOf(). Tabs are not in the list: the content
//   of another page is new, and everything else must not move.
// - Other actions (keys, mouse wheel, dragging, resizing the window) end the watch by end(). A moved pointer, a
//   lost connection and any behaviour of the robot do not.

#include <QElapsedTimer>
#include <QList>
#include <QPoint>
#include <QPointer>
#include <QRect>
#include <QSize>
#include <QStringList>
#include <QWidget>

namespace tiller::test {

/// e.g. "jog.X+ (JogKey)"; the parent's name if it has none.
QString nameOf(const QWidget& widget);

class PlacesWatch {
public:
    /// Radius around the pointer that counts, horizontally and vertically: the accuracy of a hand [px].
    static constexpr int kReach = 4;
    /// Smaller movements and changes are permitted, e.g. a selected segment or an appearing scroll bar [px].
    static constexpr int kUnnoticed = 12;
    /// The contract requires 500 ms. Timers of the window for this purpose may be 5 % early.
    static constexpr int kKeepMs = 470;

    /// True for widgets that a user can press, turn or edit.
    static bool isControl(const QWidget& widget);
    /// The part of the window that a click on this widget opens, closes, scrolls or changes; null: none.
    static const QWidget* containerOf(const QWidget& clicked);

    /// Call just before the press.
    /// `at`: position in the window [px].
    void begin(const QWidget& window, QPoint at);
    void end() { places_.clear(); }
    /// True while the watch is active.
    bool isOn();
    /// The moved controls so far, as text; empty: none.
    QStringList moved() const;
    /// Number of controls near the pointer. If it is 0, the watch checks nothing.
    int controlsAtPointer() const;

private:
    struct Place {
        QPointer<const QWidget> control;
        QRect rect;         ///< in window coordinates
        bool seen = false;  ///< near the pointer
    };

    bool isNear(const QRect& rect) const;

    QPointer<const QWidget> window_;
    QPointer<QWidget> modal_;
    QPointer<QWidget> popup_;
    bool hadModal_ = false;
    bool hadPopup_ = false;
    QPoint at_;
    QSize size_;  ///< of the window at the start: after a resize everything may move
    QList<Place> places_;
    QElapsedTimer sincePress_;
};

}  // namespace tiller::test
