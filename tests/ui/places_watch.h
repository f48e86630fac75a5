// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Nothing slides under the pointer: for half a second after a click, no control at the pointer moves and none
// comes there from elsewhere. A second click must never land on something else.
//
// The rule, as it is judged here:
// - Looked at are all controls (buttons, fields, sliders, boxes, chips) of the window that was clicked, which
//   were visible and enabled just before the press.
// - A control has moved when its place or size in the window is another one than before the press.
// - It counts when its old place was within 40 px of the pointer and to be seen there, or when its new one
//   is. What has gone, or is new, has not moved.
// - Excused is what the click itself opened, closed or switched: the watch ends when the window that was
//   clicked closes, or a dialog or a menu opens or closes. A click on a key that folds or scrolls its
//   surroundings, or filters or resizes them, excuses that part of the window and no other; containerOf() has
//   the list. A tab is not in it: what is on another page is new, and all else keeps its place.
// - Whoever acts in another way (keys, wheel, drag, another size of the window) ends the watch with end(). A
//   moved pointer, a cut link and whatever the robot does go on under it.

#include <QElapsedTimer>
#include <QList>
#include <QPoint>
#include <QPointer>
#include <QRect>
#include <QSize>
#include <QStringList>
#include <QWidget>

namespace tiller::test {

/// "jog.X+ (JogKey)"; where it has no name, whose child it is.
QString nameOf(const QWidget& widget);

class PlacesWatch {
public:
    /// How far from the pointer places count, sideways and up or down: a hand is not steadier [px].
    static constexpr int kReach = 4;
    /// What moves or grows by less is still under the same finger: a segment that is chosen, or a scroll bar that
    /// comes, takes that much [px].
    static constexpr int kUnnoticed = 12;
    /// The contract says 500 ms. Timers of the window that keep its places may be 5 % early.
    static constexpr int kKeepMs = 470;

    /// True for what a hand can press, turn or write in.
    static bool isControl(const QWidget& widget);
    /// The part of the window that a click on this widget opens, closes, scrolls or gives another shape;
    /// null: none, everything keeps its place.
    static const QWidget* containerOf(const QWidget& clicked);

    /// Just before the press.
    /// at  in the window [px]
    void begin(const QWidget& window, QPoint at);
    void end() { places_.clear(); }
    /// Under way, and neither over nor ended by what the click opened or closed.
    bool isOn();
    /// What has moved so far, in words; empty: nothing.
    QStringList moved() const;
    /// Controls whose places count at the pointer: a watch without any sees nothing.
    int controlsAtPointer() const;

private:
    struct Place {
        QPointer<const QWidget> control;
        QRect rect;         ///< in the window
        bool seen = false;  ///< at the pointer
    };

    bool isNear(const QRect& rect) const;

    QPointer<const QWidget> window_;
    QPointer<QWidget> modal_;
    QPointer<QWidget> popup_;
    bool hadModal_ = false;
    bool hadPopup_ = false;
    QPoint at_;
    QSize size_;  ///< of the window when the watch began: with another one everything may move
    QList<Place> places_;
    QElapsedTimer sincePress_;
};

}  // namespace tiller::test
