// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which keys of the keyboard are down, known by the key itself: by its native scan code, from press to
// release. What a key means is settled by its press; a modifier, a lock key or another layout in between
// changes what the release is called, but not which key was let go.

#include <QHash>
#include <QList>
#include <QSet>
#include <QtGlobal>

class QKeyEvent;

namespace tiller {

/// Number of a key of the keyboard.
using KeyCode = quint32;

/// Threads  GUI
class PhysicalKeys {
public:
    enum class Change {
        Down,       ///< a key that was up is down now
        Up,         ///< a key that was down is up now
        Repeat,     ///< the keyboard repeats a key: nothing changed
        Unknown,    ///< the release of a key whose press was not seen
        DownAgain,  ///< the press of a key that should be down already: its release was missed
    };

    /// The number of the key of an event. Where the platform tells none (events made by a program, some
    /// virtual keyboards) it is made of what the key writes: such a key can be matched only while no
    /// modifier and no layout changes, and hasNumber() is false.
    static KeyCode codeOf(const QKeyEvent& event);
    static bool hasNumber(KeyCode code) { return (code & kNoNumber) == 0; }

    /// The Qt::Key to look a command up by: what the key writes or, where that is a letter of a script without
    /// the letters of shortcuts, the letter that a US keyboard has at its place.
    static int keyOf(const QKeyEvent& event);

    /// Takes a press or a release in.
    /// meaning  remembered when the key goes down; any number
    Change take(const QKeyEvent& event, int meaning);

    bool isDown(KeyCode code) const { return down_.contains(code); }
    /// True when a key is down that meant this when it was pressed.
    bool means(int meaning) const;
    /// What a key that is down meant when it was pressed; `otherwise` when it is up.
    int meaningOf(KeyCode code, int otherwise = 0) const { return down_.value(code, otherwise); }
    QList<KeyCode> codes() const { return down_.keys(); }
    bool isEmpty() const { return down_.isEmpty(); }
    /// Releases may have gone elsewhere: nothing counts as held any more.
    void clear();

private:
    static constexpr KeyCode kNoNumber = 0x8000'0000U;

    QHash<KeyCode, int> down_;
    // A keyboard that repeats by releases and presses in pairs: both carry the same time.
    KeyCode releasedCode_ = 0;
    quint64 releasedAt_ = 0;
};

}  // namespace tiller
