// SPDX-License-Identifier: MIT
#pragma once

// The handle of a jog: a velocity that must be refreshed continuously.

#include "robot/control/motion.h"

namespace tiller::control {

/// Created by Motions::startJog(). A jog that has ended cannot be continued.
/// Threads  any. The controller must outlive the handle.
class Jog : public Motion {
public:
    Jog() = default;  ///< Creates an ended jog.

    using Motion::refresh;
    /// Keeps the jog active with a new target. A target that contains NaN ends the jog.
    /// Returns  false if the jog has ended, e.g. because this call came too late
    /// Blocks   never
    bool refresh(const JogTarget& target) const;

private:
    friend class Motions;
    explicit Jog(const Motion& motion) : Motion(motion) {}
};

}  // namespace tiller::control
