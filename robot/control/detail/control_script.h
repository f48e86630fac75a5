// SPDX-License-Identifier: MIT
#pragma once

// Generates the text of control.script for one robot, register range and session.

#include <QString>
#include <QStringList>
#include <chrono>
#include <cstdint>

#include "robot/control/controller.h"
#include "robot/control/detail/velocity_limiter.h"
#include "robot/core/version.h"

namespace tiller::control {

/// control.script, control_requests.script and control_cycle.script, concatenated.
const char* controlScriptTemplate();

/// Minimum of `abandonedAfter`, used by a client with the default timeouts.
inline constexpr std::chrono::milliseconds kMinAbandonedAfter{500};
/// Value of `abandonedAfter` for programs that other clients must not replace without confirmation. Exceeds
/// the time for which the program runs without a client.
inline constexpr std::chrono::milliseconds kNeverAbandoned{60'000};

struct ControlScript {
    QString text;
    int firstLine = 1;     ///< line of control.script at which `text` starts, for controller messages
    int sectionLine = 0;   ///< first line of the section in `text`, counted from 1
    int sectionLines = 1;  ///< number of lines of the section

    /// Description of a line of `text`, counted from 1, e.g. "control_cycle.script line 13", or "line 2" of
    /// the section.
    QString place(int line, int column) const;
};

/// version  selects the lines whose functions are available in this software version
/// session  identifies this start of the program; the program echoes it
/// arm      joint limits, for checking servo targets and for braking after torques
/// section  lines of a path or a function, run by ScriptCommand::Section. Names starting with tiller_ are
///          reserved
/// refused  functions in CALLS that this controller lacks; the program avoids them
/// abandonedAfter  time without a client after which other clients may replace the program without
///                 confirmation
ControlScript controlScript(const SoftwareVersion& version, RegisterRange range, std::int32_t session,
                            const MotionLimits& limits, const ArmLimits& arm, const QString& section = {},
                            const QStringList& refused = {}, const ForceSettings& force = {},
                            std::chrono::milliseconds abandonedAfter = kMinAbandonedAfter);

/// Returns the unknown function named in a compile error of the controller, if the program can avoid this
/// function; otherwise empty.
QString refusedName(const QString& text);

}  // namespace tiller::control
