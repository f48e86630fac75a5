// SPDX-License-Identifier: MIT
#pragma once

// Reading a program as the pendant of a CB3 or e-Series robot saves it: XML, gzipped. The pendant turns its
// nodes into URScript when it runs them. Of the nodes we know: Script (file, line), Assignment, If with its
// ElseIf and Else, Loop (endless, counted, while), Wait (time), Timer, Popup, Comment, Folder, Halt, Move
// with waypoints given as joint angles or by a variable, and External Control, see external_control.h; before
// them the sequence BeforeStart, beside them threads. A program with another node is refused as a whole: half
// a program is not what its author taught.

#include <QByteArray>
#include <QString>
#include <optional>
#include <string>

namespace tiller::simulator {

/// Gzipped, or XML with the root of a program.
bool isUrpFile(const QByteArray& content);
/// What the program does, as a `def` of that name. Nothing when it cannot be told.
std::optional<std::string> scriptOfUrp(const QByteArray& content, const QString& name);

/// Nothing when it is not gzip data, or more than `most` bytes come out.
std::optional<QByteArray> gunzip(const QByteArray& compressed, qsizetype most);

}  // namespace tiller::simulator
