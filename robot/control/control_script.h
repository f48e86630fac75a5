// SPDX-License-Identifier: MIT
#pragma once

// The text of control.script as it is sent: names filled in for one robot, one register range, one session.

#include <QString>
#include <cstdint>

#include "robot/control/controller.h"
#include "robot/core/version.h"

namespace tiller::control {

/// control.script as it stands in the source tree.
const char* controlScriptTemplate();

struct ControlScript {
    QString text;
    int firstLine = 1;  ///< of `text` in control.script, to find the lines of the controller's messages there
};

/// version  software without get_steptime() gets its control period as a number
/// session  marks this start of the program; echoed by it
ControlScript controlScript(const SoftwareVersion& version, RegisterRange range, std::int32_t session,
                            const MotionLimits& limits);

}  // namespace tiller::control
