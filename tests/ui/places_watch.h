// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Checks that nothing moves under the pointer. For half a second after a click, no control near the pointer
// may move, and no control may move to a position near the pointer, so that a second click cannot hit another
// control.
//
// The rule in detail:
// - All controls (buttons, fields, sliders, boxes, chips) of the clicked window are checked if they were
//   visible and enabled just before the press.
// - A control has moved if an edge of its rectangle in the window has moved by more than kUnnoticed.
// - A moved control counts if its old or new position is visible within kReach of the pointer. Controls that
//   disappear or appear have not moved.
// - Effects of the click itself are allowed: the watch ends when the clicked window closes, or when a dialog
//   or menu opens or closes. A click on a button that folds, scrolls, filters or resizes its surroundings
//   allows changes only in this part of the window (see the list in containerOf()). Tabs are not in the list.
//   The new page has different content, and everything else must not move.
// - Other actions (keys, mouse wheel, dragging, resizing the window) end the watch by end(). A moved pointer,
//   a lost connection and any behaviour of the robot do not end it.

#include <QElapsedTimer>
#include <QList>
#include <QPoint>
#include <QPointer>
#include <QRect>
#include <QSize>
#include <QStringList>
#include <QWidget>

namespace tiller::test {

/// The name or text of the widget and its class, e.g. "jog.X+ (JogKey)"; without a name and text, the name of
/// a parent.
QString nameOf(const QWidget& widget);

class PlacesWatch {
public:
    /// Half size of the checked area around the pointer, horizontally and vertically: the accuracy of a hand
    /// [px].
    static constexpr int kReach = 4;
    /// Smaller movements and size changes are permitted, e.g. of a selected segment or due to an appearing
    /// scroll bar [px].
    static constexpr int kUnnoticed = 12;
    /// The contract requires 500 ms. The timers of the window may expire 5 % early.
    static constexpr int kKeepMs = 470;

    /// True for widgets that a user can press, rotate or edit.
    static bool isControl(const QWidget& widget);
    /// The part of the window that a click on this widget opens, closes, scrolls or changes; null if there is
    /// none.
    static const QWidget* containerOf(const QWidget& clicked);

    /// Call this just before the press.
    /// at  position in the window [px]
    void begin(const QWidget& window, QPoint at);
    void end() { places_.clear(); }
    /// True while the watch is active.
    bool isOn();
    /// Descriptions of the controls that have moved so far; empty if none has moved.
    QStringList moved() const;
    /// Number of controls near the pointer. If it is 0, the watch checks nothing.
    int controlsAtPointer() const;

private:
    struct Place {
        QPointer<const QWidget> control;
        QRect rect;         ///< in window coordinates
        bool seen = false;  ///< true if visible near the pointer before the click
    };

    bool isNear(const QRect& rect) const;

    QPointer<const QWidget> window_;
    QPointer<QWidget> modal_;
    QPointer<QWidget> popup_;
    bool hadModal_ = false;
    bool hadPopup_ = false;
    QPoint at_;
    QSize size_;  ///< size of the window at the start; after a resize all controls may move
    QList<Place> places_;
    QElapsedTimer sincePress_;
};

}  // namespace tiller::test
