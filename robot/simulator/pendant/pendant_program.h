// SPDX-License-Identifier: MIT
#pragma once

// Reading a program as the pendant of a CB3 or e-Series robot saves it: XML, gzipped. The pendant turns its
// nodes into URScript when it runs them. Of the nodes we know: Script (file, line), Assignment, If with its
// ElseIf and Else, Loop (endless, counted, while), Wait (time), Timer, Popup, Comment, Folder, Halt, Move
// with waypoints given as joint angles or by a variable, SafeHome, CallSubProgram, suppressed nodes, and
// External Control, see external_control.h; before them the sequence BeforeStart, beside them threads and sub
// programs; in expressions variables, tokens and pins. A program with another node is refused as a whole,
// with the reason: half a program is not what its author taught.

#include <QByteArray>
#include <QString>
#include <optional>
#include <string>

#include "robot/core/result.h"
#include "robot/simulator/programs/urp_tree.h"

namespace tiller::simulator {

/// Gzipped, or XML with the root of a program.
bool isUrpFile(const QByteArray& content);
/// What the program does, as a `def` of that name.
/// Errors   FileCorrupt with line, node and reason
Result<std::string> scriptOfUrp(const QByteArray& content, const QString& name, const FileReader& files);

/// Nothing when it is not gzip data, or more than `most` bytes come out.
std::optional<QByteArray> gunzip(const QByteArray& compressed, qsizetype most);

}  // namespace tiller::simulator
