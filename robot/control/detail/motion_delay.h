// SPDX-License-Identifier: MIT
#pragma once

// The measured delay that ended a motion, for the error of the waiting caller.

#include <QString>
#include <cstdint>

#include "robot/control/control_status.h"

namespace tiller::control {

struct MotionDelay {
    enum class Kind : std::uint8_t {
        None,
        Data,       ///< no packet from the robot
        Answer,     ///< packets arrived, but the control program did not respond
        RoundTrip,  ///< the control program responded too late
        Heartbeat,  ///< the robot received no package of this PC in time
    };
    MotionId motion = kNoMotion;
    StopCause cause = StopCause::None;  ///< cause of the end, if no other cause ended the motion first
    Kind kind = Kind::None;
    /// Data, Answer: duration of the gap. RoundTrip: time from a command to its echo. Heartbeat: longest
    /// time between two packages of this PC.
    std::int64_t measuredNs = 0;
    std::int64_t limitNs = 0;    ///< the motion ends when this time is exceeded
    std::int64_t stalledNs = 0;  ///< Data: longest time in the gap for which the control thread did not run

    /// Explains the delay with the measured times, and how to prevent it.
    QString text() const;
};

}  // namespace tiller::control
