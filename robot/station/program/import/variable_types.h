// SPDX-License-Identifier: MIT
#pragma once

// Types of expressions and variables of a script, as far as they are certain. Private to
// robot/station/program/import.

#include <QHash>
#include <QString>
#include <vector>

namespace tiller::program {

struct VariableAssignment {
    QString name;
    QString value;
    bool isGlobal = false;
    /// True for an assignment in a function, or before the `global` statement of the variable.
    bool isLocal = false;
};

/// Types by name, as in the field `type` of steps. Variables that have different or uncertain types, or that
/// are local in a part of the script, are omitted.
QHash<QString, QString> variableTypes(const std::vector<VariableAssignment>& assignments);

/// Type of an expression; empty if it is not certain.
QString typeOf(const QString& expression, const QHash<QString, QString>& variables);

}  // namespace tiller::program
