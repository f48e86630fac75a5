// SPDX-License-Identifier: MIT
#pragma once

// What the controller says on its primary interface: log lines, errors, popups, the beginning and end of
// programs. And what it tells about the arm there.

#include <QMetaType>
#include <QString>
#include <array>
#include <cstdint>
#include <optional>

#include "robot/core/modes.h"
#include "robot/core/robot_model.h"
#include "robot/core/text.h"
#include "robot/core/version.h"

namespace tiller::script {

using tiller::operator<<;  // for the enumerations below

enum class MessageKind : std::uint8_t {
    Text,              ///< textmsg() of a program
    ProgramLabel,      ///< a program step became active
    Popup,             ///< shown on the pendant
    Version,           ///< first message of every connection
    SafetyMode,        ///< the safety mode changed
    ErrorCode,         ///< a numbered error: C209A0
    Key,               ///< a program started or stopped
    RequestValue,      ///< a program waits for an input on the pendant
    RuntimeException,  ///< a program could not be compiled, or failed while running
    Other,             ///< of a kind this library does not know
};

enum class MessageSeverity : std::uint8_t { Debug, Info, Warning, Violation, Fault };

struct ControllerMessage {
    std::int64_t hostTimeNs = 0;  ///< when it arrived, by the client's Clock
    std::uint64_t robotTime = 0;  ///< as sent; the unit is not documented
    MessageKind kind = MessageKind::Other;
    MessageSeverity severity = MessageSeverity::Info;
    int source = 0;  ///< -2 robot interface, -3 real-time machine, 7 controller ...
    int code = 0;    ///< ErrorCode, Key, SafetyMode
    int argument = 0;
    QString title;  ///< Key, Popup
    QString text;
    int line = 0;  ///< RuntimeException: 1-based, 0 = not given
    int column = 0;

    /// "C209A0" for an error code, empty for everything else.
    QString codeName() const;
};

/// The parts of the 10 Hz robot state that RTDE does not have.
struct PrimaryState {
    SoftwareVersion version;  ///< zeros until the version message came
    bool powerOn = false;
    bool emergencyStopped = false;
    bool protectiveStopped = false;
    bool programRunning = false;
    bool programPaused = false;
    RobotMode robotMode = RobotMode::NoController;
    SafetyMode safetyMode = SafetyMode::Undefined;
    std::uint64_t packages = 0;  ///< robot state packages seen; 0 = nothing above is valid yet
};

/// The arm's own dimensions and limits, calibration included.
struct RobotConfiguration {
    std::array<double, 6> minPosition{};  ///< [rad]
    std::array<double, 6> maxPosition{};  ///< [rad]
    std::array<double, 6> maxSpeed{};     ///< [rad/s]
    DhParameters dh;
    int robotType = 0;
    int robotSubType = 0;
};

}  // namespace tiller::script

Q_DECLARE_METATYPE(tiller::script::ControllerMessage)
