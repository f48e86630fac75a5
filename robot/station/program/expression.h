// SPDX-License-Identifier: MIT
#pragma once

// Expressions in steps are URScript on one line, with the terminals by their labels: "DI3 and count < 4", "AI0 > 2.5".

#include <QString>

namespace tiller::program {

struct Expression {
    QString script;  ///< URScript; empty when there is an error
    QString error;   ///< translated; empty: none
};

/// Checks brackets, quotes and words; whether the names exist is found when the script is compiled.
Expression parseExpression(const QString& text);

/// Whether each block of several lines of URScript has its own `end`, so that the lines can be part of a program.
bool hasWholeBlocks(const QString& script);

/// Whether a variable may have that name; `why` is translated. Names that begin with "tiller_" are reserved.
bool isVariableName(const QString& name, QString* why = nullptr);

/// A text as a string of URScript, in quotes. Line breaks become spaces.
QString scriptString(const QString& text);
/// A text as part of a comment of URScript: one line of ASCII.
QString scriptComment(const QString& text);
/// ASCII letters, digits and '_', not beginning with a digit, from any text.
QString scriptName(const QString& text);

}  // namespace tiller::program
