// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Key-state check for hold-to-run buttons. It queries the display server whether a mouse button or key is
// pressed. Window events alone are not sufficient: a frozen display server, a frozen remote desktop or a lost
// connection stops them, and another program may receive a release through a grab. A new query always returns
// the current state.
//
// X11: XcbKeyStateProbe, tested on Xvfb. The check is not available on Wayland, Windows, macOS and without a
// screen. Motions then depend on the other rules, and the window shows a note.

#include <QString>
#include <cstdint>
#include <memory>

#include "widgets/hold/physical_keys.h"

namespace tiller {

/// Threads  GUI, unless noted otherwise
class KeyStateProbe {
public:
    /// Reported state of a button or key. All times are times of queries [ns, SteadyClock].
    struct Word {
        std::int64_t askedNs = 0;  ///< time of the newest query with a reply; 0 if there is none
        std::int64_t downNs = 0;   ///< time of the newest query with the reply "pressed"; 0 if there is none
    };

    virtual ~KeyStateProbe() = default;

    /// False if no key-state check is available. In this case, no queries are made. The value never changes
    /// from true to false.
    virtual bool isThere() const = 0;
    /// Starts or stops the queries. While `wanted` is true, the state is queried about every 10 ms.
    virtual void want(bool wanted) = 0;
    /// Makes one query as soon as possible, in addition to the periodic queries.
    virtual void query() = 0;
    virtual Word leftButton() const = 0;
    virtual Word key(KeyCode code) const = 0;
    /// Time since the oldest query without a reply [ns]; 0 if all queries have a reply.
    virtual std::int64_t waitingNs() const = 0;
    /// A sentence for the operator that describes the check, or explains why it is not available.
    virtual QString description() const = 0;

    /// Returns the implementation for this platform. Its times are those of SteadyClock.
    static std::unique_ptr<KeyStateProbe> ofThisPlatform();
    /// Returns a probe without key-state checks, for a demonstration that presses on-screen buttons without a
    /// real mouse.
    static std::unique_ptr<KeyStateProbe> none();
};

}  // namespace tiller
