// SPDX-License-Identifier: MIT
#pragma once

// Expressions in steps are one-line URScript in which terminals are written by their labels, e.g. "DI3 and
// count < 4", "AI0 > 2.5".

#include <QString>

namespace tiller::program {

struct Expression {
    QString script;  ///< URScript; empty if there is an error
    QString error;   ///< translated; empty if there is no error
};

/// Checks brackets, quotes and keywords. The names are checked when the script is compiled.
Expression parseExpression(const QString& text);

/// Returns whether each block of a multi-line script is closed by `end`, so the lines can be part of a
/// program.
bool hasWholeBlocks(const QString& script);

/// Returns whether the name is valid for a variable. Names that begin with "tiller_" are reserved.
/// why  receives the translated reason
bool isVariableName(const QString& name, QString* why = nullptr);

/// Converts a string to a quoted URScript string. Line breaks become spaces.
QString scriptString(const QString& text);
/// Converts a string for a URScript comment: one line of ASCII.
QString scriptComment(const QString& text);
/// Converts any string to ASCII letters, digits and '_', not beginning with a digit.
QString scriptName(const QString& text);

}  // namespace tiller::program
