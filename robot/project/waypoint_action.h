// SPDX-License-Identifier: MIT
#pragma once

// Actions at a waypoint, executed one after the other: outputs, waits, the gripper.

#include <QJsonObject>
#include <span>
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

    bool usesPin() const;   ///< True if `group`, `pin` and `value` are used.
    bool usesTime() const;  ///< True if `seconds` is used.
    friend bool operator==(const WaypointAction&, const WaypointAction&) = default;
};
inline constexpr double kMaxActionTime = 3600;  ///< [s]

/// Properties of a kind of action, used by the file format, the texts, the editor, the execution in the
/// window and the script of a program.
struct WaypointActionKind {
    enum class Pin {
        None,
        Output,  ///< sets an output to `value`
        Input,   ///< waits until an input has `value`
    };
    enum class Time {
        None,
        Duration,  ///< waits for `seconds`, then sets the output, if any, to the opposite
        Limit,     ///< the wait for the input fails after `seconds`; 0: no limit
    };
    enum class Grip { None, Open, Close };

    WaypointAction::Kind kind;
    const char* key;  ///< key in project files
    Pin pin;
    Time time;
    Grip grip;
    double usualSeconds;  ///< initial value in the editor [s]
    // Texts in the translation context ActionWords. The arguments are the terminal and `seconds`, if used.
    const char* title;
    const char* text;          ///< text with the value on, if a pin is used
    const char* offText = "";  ///< text with the value off
    const char* unlimitedText = "";
    const char* unlimitedOffText = "";
};

/// The kinds in the order of the enumeration.
std::span<const WaypointActionKind> waypointActionKinds();
const WaypointActionKind& kindOf(const WaypointAction& action);

using WaypointActions = std::vector<WaypointAction>;

}  // namespace tiller::project
