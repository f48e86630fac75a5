// SPDX-License-Identifier: MIT
#pragma once

// Expressions in steps: one-line URScript in which terminals are written by their labels, e.g. "DI3 and count
// < 4", "AI0 > 2.5".

#include <QString>

namespace tiller::program {

struct Expression {
    QString script;  ///< URScript; empty after an error
    QString error;   ///< translated; empty without an error
};

/// Checks brackets, quotes and keywords, and replaces terminal labels such as "DI3" by function calls. Names
/// are checked when the script is compiled.
Expression parseExpression(const QString& text);

/// True if each block of a multi-line script is closed by `end`, so that the lines can be part of a program.
bool hasWholeBlocks(const QString& script);

/// True if the name is valid for a variable. Keywords, terminal labels and names that begin with "tiller_"
/// are reserved.
/// why  gets the translated reason
bool isVariableName(const QString& name, QString* why = nullptr);

/// Converts a string to a quoted URScript string. Line breaks and tabs become spaces, double quotes become
/// single quotes, and backslashes are removed.
QString scriptString(const QString& text);
/// Converts a string for a URScript comment: one line of ASCII.
QString scriptComment(const QString& text);
/// Converts any string to ASCII letters, digits and '_', without a leading digit.
QString scriptName(const QString& text);

}  // namespace tiller::program
