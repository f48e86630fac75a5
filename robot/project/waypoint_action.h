// SPDX-License-Identifier: MIT
#pragma once

// What is done at a waypoint once the arm is there, one after the other: outputs, waits, the gripper.

#include <QJsonObject>
#include <vector>

#include "robot/core/text.h"

namespace tiller::project {

using tiller::operator<<;  // for the enumerations below

/// Digital inputs and outputs of a group, as the terminals are labelled.
enum class IoGroup {
    Standard,      ///< DI 0-7, DO 0-7
    Configurable,  ///< CI 0-7, CO 0-7
    Tool,          ///< TI 0-1, TO 0-1
};
inline constexpr int pinCount(IoGroup group) {  ///< Pins count from 0.
    return group == IoGroup::Tool ? 2 : 8;
}
/// The channel of a pin, as the robot numbers its bits: 0-7 standard, 8-15 configurable, 16-17 tool.
inline constexpr int channelOf(IoGroup group, int pin) {
    return pin + (group == IoGroup::Standard ? 0 : group == IoGroup::Configurable ? 8 : 16);
}

struct WaypointAction {
    enum class Kind {
        SetOutput,     ///< `group`, `pin` becomes `value`
        PulseOutput,   ///< `group`, `pin` becomes `value` for `seconds`, and the other value afterwards
        WaitForInput,  ///< until `group`, `pin` has `value`, for at most `seconds`; 0: as long as it is held
        WaitTime,      ///< `seconds`
        OpenGripper,
        CloseGripper,
    };
    Kind kind = Kind::WaitTime;
    IoGroup group = IoGroup::Standard;
    int pin = 0;
    bool value = true;
    double seconds = 0;  ///< 0 ... kLongestAction
    QJsonObject extra;   ///< fields of the file that this version does not know

    bool usesPin() const {  ///< `group`, `pin` and `value` mean something.
        return kind == Kind::SetOutput || kind == Kind::PulseOutput || kind == Kind::WaitForInput;
    }
    bool usesTime() const {  ///< `seconds` means something.
        return kind == Kind::PulseOutput || kind == Kind::WaitForInput || kind == Kind::WaitTime;
    }
    friend bool operator==(const WaypointAction&, const WaypointAction&) = default;
};
inline constexpr double kLongestAction = 3600;  ///< [s]

using WaypointActions = std::vector<WaypointAction>;

}  // namespace tiller::project
