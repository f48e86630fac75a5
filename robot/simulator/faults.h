// SPDX-License-Identifier: MIT
#pragma once

// Faults and manual actions on request. Each request is a line of words. Simulator::inject(), the fault port
// and `tiller-cli simulate --fault` accept the same lines.
//
//     protective-stop          safeguard on          link lost          delay 20 5
//
// The reply to a line is `ok`, `ok` and the requested value, or `error: ` and the reason.

#include <QString>
#include <string>
#include <string_view>

#include "robot/core/result.h"

namespace tiller::simulator {

struct ControllerServices;

/// Injects the fault or executes the action that the line describes.
/// Returns  the value requested by the line; empty if it requests none
/// Errors   InvalidArgument, with the reason
/// Threads  the simulator thread
Result<QString> injectFault(ControllerServices& controlBox, const QString& line);
/// Executes a line and returns the reply in the format of the fault port, newline included.
std::string answerFaultLine(ControllerServices& controlBox, std::string_view line);
/// Help text with one paragraph for each type of line.
QString faultHelp();

}  // namespace tiller::simulator
