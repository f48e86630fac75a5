// SPDX-License-Identifier: MIT
#pragma once

// Actions executed one after the other at a waypoint: outputs, waits, the gripper.

#include <QJsonObject>
#include <vector>

#include "robot/core/text.h"

namespace tiller::project {

using tiller::operator<<;  // makes the enumerations below printable

/// Digital inputs and outputs by group, as labelled on the terminals.
enum class IoGroup {
    Standard,      ///< DI 0-7, DO 0-7
    Configurable,  ///< CI 0-7, CO 0-7
    Tool,          ///< TI 0-1, TO 0-1
};
inline constexpr int pinCount(IoGroup group) {  ///< Pins count from 0.
    return group == IoGroup::Tool ? 2 : 8;
}
/// Bit number of a pin in the robot's data: 0-7 standard, 8-15 configurable, 16-17 tool.
inline constexpr int channelOf(IoGroup group, int pin) {
    return pin + (group == IoGroup::Standard ? 0 : group == IoGroup::Configurable ? 8 : 16);
}

struct WaypointAction {
    enum class Kind {
        SetOutput,     ///< set `group`, `pin` to `value`
        PulseOutput,   ///< set `group`, `pin` to `value` for `seconds`, then to the opposite
        WaitForInput,  ///< wait until `group`, `pin` has `value`, at most `seconds`; 0: no limit
        WaitTime,      ///< wait for `seconds`
        OpenGripper,
        CloseGripper,
    };
    Kind kind = Kind::WaitTime;
    IoGroup group = IoGroup::Standard;
    int pin = 0;
    bool value = true;
    double seconds = 0;  ///< 0 ... kMaxActionTime
    QJsonObject extra;   ///< unknown fields of the file, preserved when saving

    bool usesPin() const {  ///< True if `group`, `pin` and `value` are used.
        return kind == Kind::SetOutput || kind == Kind::PulseOutput || kind == Kind::WaitForInput;
    }
    bool usesTime() const {  ///< True if `seconds` is used.
        return kind == Kind::PulseOutput || kind == Kind::WaitForInput || kind == Kind::WaitTime;
    }
    friend bool operator==(const WaypointAction&, const WaypointAction&) = default;
};
inline constexpr double kMaxActionTime = 3600;  ///< [s]

using WaypointActions = std::vector<WaypointAction>;

}  // namespace tiller::project
