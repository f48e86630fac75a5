// SPDX-License-Identifier: MIT
#pragma once

// Messages that the controller sends on the primary interface (log lines, errors, popups, start and end of
// programs), and the arm configuration received there.

#include <QMetaType>
#include <QString>
#include <array>
#include <cstdint>
#include <optional>

#include "robot/core/modes.h"
#include "robot/core/robot_model.h"
#include "robot/core/text.h"
#include "robot/core/version.h"
#include "robot/script/program_variables.h"

namespace tiller::script {

using tiller::operator<<;  // makes the enumerations below printable

enum class MessageKind : std::uint8_t {
    Text,              ///< textmsg() of a program
    ProgramLabel,      ///< a program step became active
    Popup,             ///< shown on the teach pendant
    Version,           ///< first message of every connection
    SafetyMode,        ///< the safety mode changed
    ErrorCode,         ///< a numbered error, e.g. C209A0
    Key,               ///< a program started or stopped
    RequestValue,      ///< a program is waiting for operator input on the teach pendant
    RuntimeException,  ///< a program could not be compiled or failed at run time
    Other,             ///< unknown to this library
};

enum class MessageSeverity : std::uint8_t { Debug, Info, Warning, Violation, Fault };

struct ControllerMessage {
    std::int64_t hostTimeNs = 0;  ///< time of arrival on the client's Clock
    std::uint64_t robotTime = 0;  ///< time stamp of the controller; the unit is not documented
    MessageKind kind = MessageKind::Other;
    MessageSeverity severity = MessageSeverity::Info;
    int source = 0;  ///< -2 robot interface, -3 real-time machine, 7 controller ...
    int code = 0;    ///< for ErrorCode, Key and SafetyMode
    int argument = 0;
    QString title;  ///< for Key and Popup
    QString text;
    int line = 0;  ///< for RuntimeException: 1-based, 0 = unknown
    int column = 0;

    /// Name of an error code, e.g. "C209A0"; otherwise empty.
    QString codeName() const;
};

/// Values that the robot sends ten times per second and that RTDE does not provide.
struct PrimaryState {
    SoftwareVersion version;  ///< zeros until the version message is received
    bool powerOn = false;
    bool emergencyStopped = false;
    bool protectiveStopped = false;
    bool programRunning = false;
    bool programPaused = false;
    RobotMode robotMode = RobotMode::NoController;
    SafetyMode safetyMode = SafetyMode::Undefined;
    ProgramVariables variables;  ///< variables of the running or paused program
    std::uint64_t packages = 0;  ///< number of robot state packages received; 0: no valid values yet
};

/// Dimensions and limits of the individual arm, including calibration.
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
