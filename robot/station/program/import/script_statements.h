// SPDX-License-Identifier: MIT
#pragma once

// Splits URScript text into statements and blocks, without evaluating them. Each statement contains its line
// numbers, so that it can be kept as text.

#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "robot/core/result.h"
#include "robot/simulator/pendant/script_text.h"

namespace tiller::program {

struct ScriptStatement {
    enum class Kind {
        Simple,    ///< `code` is the statement without its comment
        If,        ///< see `branches`
        While,     ///< `code` is the condition
        Function,  ///< def, thread or sec; `code` is its first line
        Comment,   ///< `code` is the text
        // from the marks of a pendant program:
        Folder,    ///< `code` is the name
        Disabled,  ///< `body` must not run
        Omitted,   ///< `code` is the reason
    };
    struct Branch {
        QString condition;  ///< empty: else
        std::vector<ScriptStatement> body;
    };
    Kind kind = Kind::Simple;
    int first = 0;  ///< index of the first line
    int last = 0;   ///< index of the last line
    QString code = {};
    int node = 0;           ///< line of the node in the program tree of the teach pendant; 0: none
    QString nodeName = {};  ///< text of the node in the program tree
    std::vector<ScriptStatement> body = {};
    std::vector<Branch> branches = {};
};

/// Errors   ScriptError with the line: a block is not closed, or several statements share a line
Result<std::vector<ScriptStatement>> splitScript(const QStringList& lines,
                                                 const std::vector<simulator::pendant::NodeMark>& marks = {});

/// A line without its comment and surrounding spaces.
QString codeOf(const QString& line);

struct ScriptArgument {
    QString name;  ///< empty: positional
    QString text;
};
/// A call that is a whole statement or expression.
struct ScriptCall {
    QString function;
    std::vector<ScriptArgument> arguments;
    /// The texts of the arguments in the order of `names`, empty where missing. Returns no value if there are
    /// too many arguments or other names.
    std::optional<QStringList> bind(const QStringList& names) const;
};
std::optional<ScriptCall> parseCall(const QString& code);

/// Removes brackets around the whole expression.
QString withoutBrackets(QString expression);
std::optional<double> numberLiteral(const QString& text);
/// The numbers of a list with `count` numbers; `prefix` is "p" for a pose and empty for joint positions.
std::optional<std::vector<double>> listLiteral(const QString& text, const QString& prefix, qsizetype count);
/// The content of a string literal without special characters.
std::optional<QString> stringLiteral(const QString& text);

}  // namespace tiller::program
