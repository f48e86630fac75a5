// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Key-state check for hold-to-run keys: asks the display server whether a mouse button or key is pressed.
// Window events alone are not sufficient: they may stop (frozen display server or remote desktop, lost
// connection), or one may be delivered elsewhere (a grab by another program). A new query always returns the
// current state.
//
// X11: XcbKeyStateProbe, tested on Xvfb. Not available on Wayland, Windows, macOS and without a screen: motions
// then depend on the other rules, and the window shows a note.

#include <QString>
#include <cstdint>
#include <memory>

#include "widgets/hold/physical_keys.h"

namespace tiller {

/// Threads  GUI, unless noted otherwise
class KeyStateProbe {
public:
    /// Reported state of one button or key. Times are those of the queries [ns, SteadyClock].
    struct Word {
        std::int64_t askedNs = 0;  ///< newest answered query; 0: none
        std::int64_t downNs = 0;   ///< newest query answered with "pressed"; 0: none
    };

    virtual ~KeyStateProbe() = default;

    /// False if no key-state check is available; then no queries are made. Never changes from true to false.
    virtual bool isThere() const = 0;
    /// While wanted, queries the state about every 10 ms; otherwise the thread sleeps.
    virtual void want(bool wanted) = 0;
    virtual Word leftButton() const = 0;
    virtual Word key(KeyCode code) const = 0;
    /// Time since the newest unanswered query [ns]; 0: all queries are answered.
    virtual std::int64_t waitingNs() const = 0;
    /// A sentence for the operator: the type of the check, or the reason why it is not available.
    virtual QString description() const = 0;

    /// The implementation for this platform; its times are those of SteadyClock.
    static std::unique_ptr<KeyStateProbe> ofThisPlatform();
    /// No key-state check, for a demonstration that presses keys on the screen without a mouse.
    static std::unique_ptr<KeyStateProbe> none();
};

}  // namespace tiller
