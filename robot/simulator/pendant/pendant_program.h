// SPDX-License-Identifier: MIT
#pragma once

// Reading a program as the pendant saves it: `.urp` of PolyScope 3 and 5 (XML, gzipped) and `.urpx` of PolyScope X
// (JSON). The pendant turns its nodes into URScript when it plays them; so does this module, which knows nothing of
// the simulated controller around it. A node that cannot be translated faithfully makes the program refused as a
// whole, with line, node and reason. README.md of the simulator lists the nodes.

#include <QByteArray>
#include <QString>
#include <functional>
#include <optional>
#include <string>

#include "robot/core/result.h"
#include "robot/core/version.h"
#include "robot/simulator/pendant/urcaps.h"

namespace tiller::simulator::pendant {

/// Other files of the programs folder, by the name a program gives; nothing when there is none.
using FileReader = std::function<std::optional<QByteArray>(const QString& name)>;

/// What a program is read with.
struct PendantSource {
    FileReader files;
    /// The installation of a program that names none, or one that is not there.
    QString installation = QStringLiteral("default.installation");
    SoftwareVersion software{5, 22, 0, 0};
    UrcapStandIns urcaps = UrcapStandIns::builtIn();
    UnknownUrcap unknownUrcap = UnknownUrcap::Refuse;
    /// Names of the language, which a function of the program must not have.
    std::function<bool(const QString& name)> isReserved = {};
    bool eventNeedsEdge =
        false;  ///< an event runs once each time its condition becomes true, not while it is true
};

struct PendantProgram {
    std::string script;  ///< a `def`
    /// The first node that its author has not finished: the program can be loaded, and not played.
    std::optional<Error> unfinished = {};
};

/// Gzipped, or XML with the root of a program.
bool isUrpFile(const QByteArray& content);
/// name    of the `def`
/// Errors  FileCorrupt with line, node and reason
Result<PendantProgram> readUrp(const QByteArray& content, const QString& name, const PendantSource& source);
/// A program of PolyScope X has the URScript of its nodes within.
/// Errors  FileCorrupt with the reason
Result<PendantProgram> readUrpx(const QByteArray& content);

}  // namespace tiller::simulator::pendant
