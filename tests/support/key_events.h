// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Keys as a display server tells them: by their place on the keyboard, with whatever layout and modifiers
// make of them.

#include <QApplication>
#include <QKeyEvent>
#include <QWidget>

namespace tiller::test {

/// X11 numbers of keys of a PC keyboard.
namespace scan {
inline constexpr quint32 k1 = 10;  ///< 2 ... 6 follow
inline constexpr quint32 kDashUs = 20;
inline constexpr quint32 kEqualUs = 21;
inline constexpr quint32 kPlusDe = 35;
inline constexpr quint32 kMinusDe = 61;
inline constexpr quint32 kControl = 37;
inline constexpr quint32 kShift = 50;
inline constexpr quint32 kAlt = 64;
inline constexpr quint32 kNumLock = 77;
inline constexpr quint32 kPad4 = 83;
inline constexpr quint32 kHome = 110;
inline constexpr quint32 kUp = 111;
inline constexpr quint32 kPageUp = 112;
inline constexpr quint32 kLeft = 113;
inline constexpr quint32 kRight = 114;
inline constexpr quint32 kG = 42;
}  // namespace scan

struct KeyNews {
    Qt::KeyboardModifiers modifiers = {};
    bool repeat = false;
    quint64 timestamp = 0;
};

inline void sendKey(QWidget& to, QEvent::Type type, quint32 scanCode, int key, const KeyNews& news = {}) {
    QKeyEvent event(type, key, news.modifiers, scanCode, 0, 0, QString(), news.repeat);
    event.setTimestamp(news.timestamp);
    QApplication::sendEvent(&to, &event);
}
inline void keyDown(QWidget& to, quint32 scanCode, int key, const KeyNews& news = {}) {
    sendKey(to, QEvent::KeyPress, scanCode, key, news);
}
inline void keyUp(QWidget& to, quint32 scanCode, int key, const KeyNews& news = {}) {
    sendKey(to, QEvent::KeyRelease, scanCode, key, news);
}

}  // namespace tiller::test
