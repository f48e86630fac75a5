// SPDX-License-Identifier: MIT
#pragma once

// Reads programs saved by the teach pendant: `.urp` of PolyScope 3 and 5 (XML, gzipped) and `.urpx` of
// PolyScope X (JSON). When the teach pendant plays a program, it converts the nodes to URScript. This module
// performs the same conversion. It is independent of the simulated controller. If a node cannot be translated
// faithfully, the whole program is refused, with line, node and reason. README.md of the simulator lists the
// supported nodes.

#include <QByteArray>
#include <QString>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/core/version.h"
#include "robot/simulator/pendant/script_text.h"
#include "robot/simulator/pendant/urcaps.h"

namespace tiller::simulator::pendant {

/// Reads another file of the programs folder by the name used in a program. Empty if it does not exist.
using FileReader = std::function<std::optional<QByteArray>(const QString& name)>;

/// Input for reading a program.
struct PendantSource {
    FileReader files;
    /// Installation for programs that do not name one or whose installation is missing.
    QString installation = QStringLiteral("default.installation");
    SoftwareVersion software{5, 22, 0, 0};
    UrcapStandIns urcaps = UrcapStandIns::builtIn();
    UnknownUrcap unknownUrcap = UnknownUrcap::Refuse;
    /// True for reserved words of the language, which are not permitted as function names.
    std::function<bool(const QString& name)> isReserved = {};
    /// True for functions of this software version; empty: all are available.
    std::function<bool(const QString& name)> hasFunction = {};
    bool eventNeedsEdge =
        false;  ///< an event runs once each time its condition becomes true, instead of while it is true
    /// Translates disabled nodes as well, between marks. The script must not be played then.
    bool keepsDisabled = false;
};

struct PendantProgram {
    std::string script;  ///< complete function, starting with `def`
    /// The first unfinished node. A program with such a node can be loaded but cannot be played.
    std::optional<Error> unfinished = {};
    std::vector<NodeMark> marks = {};  ///< marks of a `.urp` program, in line order
};

/// True for gzipped data, or for XML with a program as its root.
bool isUrpFile(const QByteArray& content);
/// name    name of the `def`
/// Errors  FileCorrupt with line, node and reason
Result<PendantProgram> readUrp(const QByteArray& content, const QString& name, const PendantSource& source);
/// Programs of PolyScope X contain the URScript of their nodes.
/// Errors  FileCorrupt with the reason
Result<PendantProgram> readUrpx(const QByteArray& content);

}  // namespace tiller::simulator::pendant
