// SPDX-License-Identifier: MIT
#pragma once

// Converts the statements of a script to steps. Private to robot/station/program/import.

#include <QStringList>
#include <vector>

#include "robot/simulator/pendant/script_text.h"
#include "robot/station/program/import/program_import.h"

namespace tiller::program {

/// lines  lines of a script: one `def`, or statements
/// marks  marks of a pendant program
/// Errors   ScriptError with the reason
Result<ImportedProgram> importStatements(const project::Project& project, const QString& name,
                                         const QStringList& lines,
                                         const std::vector<simulator::pendant::NodeMark>& marks);

}  // namespace tiller::program
