// SPDX-License-Identifier: MIT
#pragma once

// The handle of a jog: a velocity that somebody keeps asking for.

#include "robot/control/motion.h"

namespace tiller::control {

/// Made by Motions::startJog. A jog that has ended takes a new start.
/// Threads  any. The controller must outlive it.
class Jog : public Motion {
public:
    Jog() = default;  ///< of nothing: ended

    using Motion::refresh;
    /// Keeps it alive, with this target from now on. One that holds no numbers ends it.
    /// Returns  false when the jog has ended, if only by this call coming too late
    /// Blocks   never
    bool refresh(const JogTarget& target) const;

private:
    friend class Motions;
    explicit Jog(const Motion& motion) : Motion(motion) {}
};

}  // namespace tiller::control
