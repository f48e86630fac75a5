// SPDX-License-Identifier: MIT
#pragma once

// Expressions in steps are one-line URScript, with terminals written by their labels: "DI3 and count < 4",
// "AI0 > 2.5".

#include <QString>

namespace tiller::program {

struct Expression {
    QString script;  ///< URScript; empty when there is an error
    QString error;   ///< translated; empty: none
};

/// Checks brackets, quotes and keywords. Whether the names exist is checked when the script is compiled.
Expression parseExpression(const QString& text);

/// Returns whether each block of a multi-line script has its own `end`, so that the lines can be part of a
/// program.
bool hasWholeBlocks(const QString& script);

/// Returns whether the name is valid for a variable; `why` is translated. Names that begin with "tiller_" are
/// reserved.
bool isVariableName(const QString& name, QString* why = nullptr);

/// Quotes a text as a URScript string. Line breaks become spaces.
QString scriptString(const QString& text);
/// Converts a text for a URScript comment: one line of ASCII.
QString scriptComment(const QString& text);
/// Converts any text to ASCII letters, digits and '_', not beginning with a digit.
QString scriptName(const QString& text);

}  // namespace tiller::program
