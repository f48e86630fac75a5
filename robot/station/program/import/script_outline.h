// SPDX-License-Identifier: MIT
#pragma once

// The statements of a script as a whole: the main program, its variables, and the text of any part. Private
// to robot/station/program/import.

#include <QHash>
#include <QSet>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "robot/station/program/import/script_statements.h"

namespace tiller::program {

using Statements = std::vector<ScriptStatement>;

/// Calls `visit` for each statement, also inside of blocks.
template <class Visit>
void forEachStatement(const Statements& list, bool inFunction, const Visit& visit) {
    for (const ScriptStatement& statement : list) {
        visit(statement, inFunction);
        forEachStatement(statement.body, inFunction || statement.kind == ScriptStatement::Kind::Function,
                         visit);
        for (const ScriptStatement::Branch& branch : statement.branches) {
            forEachStatement(branch.body, inFunction, visit);
        }
    }
}

/// True if a statement of the list, but not of a function in it, begins with this word.
bool hasWord(const Statements& list, const QString& word);
bool callsSetTcp(const QString& text);

class ScriptOutline {
public:
    /// lines  must outlive the object
    explicit ScriptOutline(const QStringList& lines) : lines_(lines) {}

    /// Selects the statements of the main program.
    /// Returns  why there are none; otherwise empty
    QString findMain(Statements top);
    /// Determines the variables and constants of the main program and its disabled lines.
    void analyse();
    /// Moves the statements before the first node into a folder.
    void foldInstallation();

    const Statements& main() const { return main_; }
    /// True if the script was written for a pendant program, with nodes.
    bool isPendant() const { return isPendant_; }
    bool functionSetsTcp() const { return functionSetsTcp_; }
    /// Types of the variables, as in the field `type` of steps.
    const QHash<QString, QString>& types() const { return types_; }
    /// True for a global variable with one assignment.
    bool isConstant(const QString& name) const { return constants_.contains(name); }
    /// How often a word occurs in the script, outside of strings.
    int occurrences(const QString& word) const;

    /// The lines between the first `def` and the last `end`.
    std::optional<QString> textOfDefinition() const;
    /// The lines of a statement without labels, disabled nodes and common indentation.
    QString textOf(const ScriptStatement& statement) const;
    QString textOf(const Statements& list) const;

private:
    const QStringList& lines_;
    Statements main_;
    QString code_;  ///< text of all statements
    bool isPendant_ = false;
    bool functionSetsTcp_ = false;
    QSet<int> disabledLines_;
    QHash<QString, QString> types_;
    QSet<QString> constants_;
};

}  // namespace tiller::program
