// SPDX-License-Identifier: MIT
#pragma once

// The text of control.script as it is sent: names filled in for one robot, one register range, one session.

#include <QString>
#include <QStringList>
#include <cstdint>

#include "robot/control/controller.h"
#include "robot/control/detail/velocity_limiter.h"
#include "robot/core/version.h"

namespace tiller::control {

/// control.script, control_requests.script and control_cycle.script, one after the other.
const char* controlScriptTemplate();

struct ControlScript {
    QString text;
    int firstLine = 1;  ///< of `text` in control.script, to find the lines of the controller's messages there
    int sectionLine = 0;   ///< of the section in `text`, counted from 1
    int sectionLines = 1;  ///< how many it takes

    /// What a line of `text`, counted from 1, is called: "control_cycle.script line 13", or "line 2" of the
    /// section.
    QString place(int line, int column) const;
};

/// version  software without a function gets the lines that do without it
/// session  marks this start of the program; echoed by it
/// arm      what its joints can do: by that servo targets are judged, and torques braked
/// section  lines of a path or a function, run by ScriptCommand::Section. Names beginning with tiller_ are
/// the
///          program's own
/// refused  names in CALLS that this controller does not know: the program does without them
ControlScript controlScript(const SoftwareVersion& version, RegisterRange range, std::int32_t session,
                            const MotionLimits& limits, const ArmLimits& arm, const QString& section = {},
                            const QStringList& refused = {}, const ForceSettings& force = {});

/// Of what the controller says when it cannot compile the program: the name that it does not know, if the
/// program can do without it; else empty.
QString refusedName(const QString& text);

}  // namespace tiller::control
