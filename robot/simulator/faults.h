// SPDX-License-Identifier: MIT
#pragma once

// Everything that can go wrong, or that a hand can do, on demand: one line of words each. The same words are
// taken by Simulator::inject(), by the fault port and by `tiller-cli simulate --fault`.
//
//     protective-stop          safeguard on          link lost          delay 20 5
//
// A line is answered with `ok`, with `ok` and what was asked for, or with `error: ` and the reason.

#include <QString>
#include <string>
#include <string_view>

#include "robot/core/result.h"

namespace tiller::simulator {

struct ControlBox;

/// Does what a line says.
/// Returns  what was asked for, usually nothing
/// Errors   InvalidArgument, with the reason
/// Threads  the simulator's
Result<QString> injectFault(ControlBox& controlBox, const QString& line);
/// The same as the fault port speaks, newline included.
std::string answerFaultLine(ControlBox& controlBox, std::string_view line);
/// All lines there are, one paragraph of text.
QString faultHelp();

}  // namespace tiller::simulator
