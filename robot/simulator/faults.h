// SPDX-License-Identifier: MIT
#pragma once

// Faults and manual actions on request, one line of words each. The same words are accepted by Simulator::inject(),
// the fault port and `tiller-cli simulate --fault`.
//
//     protective-stop          safeguard on          link lost          delay 20 5
//
// A line is answered with `ok`, with `ok` and the requested value, or with `error: ` and the reason.

#include <QString>
#include <string>
#include <string_view>

#include "robot/core/result.h"

namespace tiller::simulator {

struct ControllerServices;

/// Executes a line.
/// Returns  the requested value, usually empty
/// Errors   InvalidArgument, with the reason
/// Threads  the simulator's
Result<QString> injectFault(ControllerServices& controlBox, const QString& line);
/// The same in the format of the fault port, newline included.
std::string answerFaultLine(ControllerServices& controlBox, std::string_view line);
/// Help on all lines, one paragraph of text.
QString faultHelp();

}  // namespace tiller::simulator
