// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The set of pressed keys. Native scan codes identify a key from press to release. The meaning of a key is
// determined when it is pressed. A changed modifier, lock key or keyboard layout changes the key symbol of
// the release event, but not the scan code.

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
        DownAgain,  ///< press of a key that was already down, because its release was missed
    };

    /// Returns the number of the key in an event. If the platform does not provide a number (synthetic
    /// events, some virtual keyboards), it is derived from the key symbol. In this case, press and release
    /// can be matched only while modifiers and layout do not change, and hasNumber() returns false.
    static KeyCode codeOf(const QKeyEvent& event);
    static bool hasNumber(KeyCode code) { return (code & kNoNumber) == 0; }

    /// Returns the Qt::Key for looking up a command: the key symbol or, for letters of a non-Latin script,
    /// the letter at this position on a US keyboard.
    static int keyOf(const QKeyEvent& event);

    /// Processes a press or release.
    /// meaning  any value; stored with the key at the press
    Change take(const QKeyEvent& event, int meaning);

    bool isDown(KeyCode code) const { return down_.contains(code); }
    bool means(int meaning) const;
    /// The meaning of a pressed key, or `otherwise` if the key is not pressed.
    int meaningOf(KeyCode code, int otherwise = 0) const { return down_.value(code, otherwise); }
    QList<KeyCode> codes() const { return down_.keys(); }
    bool isEmpty() const { return down_.isEmpty(); }
    /// Clears all pressed keys. Call this when releases may have been missed.
    void clear();

private:
    static constexpr KeyCode kNoNumber = 0x8000'0000U;

    QHash<KeyCode, int> down_;
    // Last release, for detecting repetitions that are sent as release and press with equal time stamps.
    KeyCode releasedCode_ = 0;
    quint64 releasedAt_ = 0;
};

}  // namespace tiller
