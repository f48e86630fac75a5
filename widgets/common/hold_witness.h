// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The second witness of a hold: the display server itself, asked whether a mouse button or a key is down. The
// events of the window may stop coming (a frozen or lost display server, a frozen remote desktop) or one of
// them may go elsewhere (a grab of another program); what the server answers to a question just put does not.
//
// X11: XcbWitness, tested on Xvfb. On Wayland, Windows and macOS, and without a screen, there is none yet:
// motions go on there under the other rules, and the window says so.

#include <QString>
#include <cstdint>
#include <memory>

#include "widgets/common/physical_keys.h"

namespace tiller {

/// Threads  GUI, unless said otherwise
class HoldWitness {
public:
    /// What was said about one button or key, by the time at which the question was put [ns, SteadyClock].
    struct Word {
        std::int64_t askedNs = 0;  ///< the newest question that was answered; 0: none was
        std::int64_t downNs = 0;   ///< the newest one that was answered with "down"; 0: none was
    };

    virtual ~HoldWitness() = default;

    /// False where there is none: then nothing is asked of it. Once there, it stays there.
    virtual bool isThere() const = 0;
    /// While wanted it asks about every 10 ms; otherwise it sleeps.
    virtual void want(bool wanted) = 0;
    virtual Word leftButton() const = 0;
    virtual Word key(KeyCode code) const = 0;
    /// How long the newest question has been waiting for its answer [ns]; 0: none waits.
    virtual std::int64_t waitingNs() const = 0;
    /// A sentence for the operator: who it is, or why there is none.
    virtual QString description() const = 0;

    /// The one of this platform, whose words go by the steady clock.
    static std::unique_ptr<HoldWitness> ofThisPlatform();
    /// For a hand that is none: a demonstration presses keys of the screen without a mouse.
    static std::unique_ptr<HoldWitness> none();
};

}  // namespace tiller
