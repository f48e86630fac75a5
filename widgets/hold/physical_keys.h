// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The set of pressed keys, identified by native scan codes from press to release. The meaning of a key is
// determined when it is pressed. A modifier, a lock key or another keyboard layout changes the name of the release
// event, but not its key.

#include <QHash>
#include <QList>
#include <QSet>
#include <QtGlobal>

class QKeyEvent;

namespace tiller {

/// Number of a physical key.
using KeyCode = quint32;

/// Threads  GUI
class PhysicalKeys {
public:
    enum class Change {
        Down,       ///< the key was pressed
        Up,         ///< the key was released
        Repeat,     ///< key repeat: no change
        Unknown,    ///< release of a key whose press was not received
        DownAgain,  ///< press of a key that was already down: its release was missed
    };

    /// The number of the key in an event. If the platform does not provide one (synthetic events, some virtual
    /// keyboards), it is derived from the key symbol: such a key can be matched only while modifiers and layout do
    /// not change, and hasNumber() is false.
    static KeyCode codeOf(const QKeyEvent& event);
    static bool hasNumber(KeyCode code) { return (code & kNoNumber) == 0; }

    /// The Qt::Key for looking up a command: the key symbol or, for letters of a script without Latin letters, the
    /// letter at this position of a US keyboard.
    static int keyOf(const QKeyEvent& event);

    /// Processes a press or release.
    /// meaning  any number, stored when the key is pressed
    Change take(const QKeyEvent& event, int meaning);

    bool isDown(KeyCode code) const { return down_.contains(code); }
    /// True if a key with this meaning is down.
    bool means(int meaning) const;
    /// The meaning of a key that is down; `otherwise` if it is up.
    int meaningOf(KeyCode code, int otherwise = 0) const { return down_.value(code, otherwise); }
    QList<KeyCode> codes() const { return down_.keys(); }
    bool isEmpty() const { return down_.isEmpty(); }
    /// Clears all pressed keys, because releases may have been missed.
    void clear();

private:
    static constexpr KeyCode kNoNumber = 0x8000'0000U;

    QHash<KeyCode, int> down_;
    // For keyboards that repeat with release and press events of equal time stamps.
    KeyCode releasedCode_ = 0;
    quint64 releasedAt_ = 0;
};

}  // namespace tiller
