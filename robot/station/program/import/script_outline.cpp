// SPDX-License-Identifier: MIT
#include "robot/station/program/import/script_outline.h"

#include <QRegularExpression>
#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "robot/station/program/import/variable_types.h"
#include "robot/station/program/program_text.h"

namespace tiller::program {

bool hasWord(const Statements& list, const QString& word) {
    const QRegularExpression begin(QStringLiteral("^%1\\b").arg(word));
    bool found = false;
    forEachStatement(list, false, [&](const ScriptStatement& statement, bool inFunction) {
        found = found || (!inFunction && statement.kind == ScriptStatement::Kind::Simple &&
                          begin.match(statement.code).hasMatch());
    });
    return found;
}

bool callsSetTcp(const QString& text) {
    return text.contains(QLatin1String("set_tcp"));
}

QString ScriptOutline::findMain(Statements top) {
    static const QRegularExpression def(QStringLiteral("^(?:def|sec)\\s+(\\w+)\\s*\\(\\s*\\)\\s*:$"));
    Statements comments;
    std::vector<ScriptStatement*> functions, others;
    for (ScriptStatement& statement : top) {
        if (statement.kind == ScriptStatement::Kind::Comment ||
            statement.kind == ScriptStatement::Kind::Omitted) {
            comments.push_back(statement);
        } else {
            (statement.kind == ScriptStatement::Kind::Function ? functions : others).push_back(&statement);
        }
    }
    const auto name = functions.size() == 1 ? def.match(functions.front()->code) : QRegularExpressionMatch();
    if (name.hasMatch() &&
        (others.empty() || (others.size() == 1 && others.front()->code == name.captured(1) + "()"))) {
        main_ = std::move(comments);
        std::move(functions.front()->body.begin(), functions.front()->body.end(), std::back_inserter(main_));
    } else if (others.empty()) {
        return functions.empty() ? ProgramText::tr("the file contains no statements")
                                 : ProgramText::tr(
                                       "the file contains %1 functions or parameters, but no statement that "
                                       "calls a function; add the call")
                                       .arg(functions.size());
    } else {
        main_ = std::move(top);
    }
    return main_.empty() ? ProgramText::tr("the program contains no statements") : QString();
}

void ScriptOutline::foldInstallation() {
    const auto end = std::find_if(main_.begin(), main_.end(), [](const ScriptStatement& statement) {
        return statement.node > 0 || statement.kind == ScriptStatement::Kind::Function;
    });
    if (end - main_.begin() < 2) {
        return;
    }
    ScriptStatement folder;
    folder.kind = ScriptStatement::Kind::Folder;
    folder.first = main_.front().first;
    folder.last = (end - 1)->last;
    folder.code = ProgramText::tr("Installation");
    folder.body.assign(std::make_move_iterator(main_.begin()), std::make_move_iterator(end));
    main_.erase(main_.begin(), end);
    main_.insert(main_.begin(), std::move(folder));
}

std::optional<QString> ScriptOutline::textOfDefinition() const {
    static const QRegularExpression def(QStringLiteral("^\\s*def\\s+\\w+\\s*\\(\\s*\\)\\s*:\\s*$"));
    const qsizetype first = lines_.indexOf(def);
    const qsizetype last = lines_.lastIndexOf(QRegularExpression(QStringLiteral("^\\s*end\\s*$")));
    const QString text =
        first < 0 || last <= first ? QString() : lines_.mid(first + 1, last - first - 1).join('\n');
    return text.trimmed().isEmpty() || !hasWholeBlocks(text) ? std::nullopt : std::optional(text);
}

void ScriptOutline::analyse() {
    QStringList codes;
    QHash<QString, int> assignments;
    QSet<QString> globals;
    std::vector<VariableAssignment> values;
    static const QRegularExpression assignment(
        QStringLiteral("^(global\\s+|local\\s+)?([A-Za-z_]\\w*)\\s*=(?!=)\\s*(.+)$"));
    // Matches an assignment to an element or a member, and a method call. Each of them may change the
    // variable.
    static const QRegularExpression element(QStringLiteral("^([A-Za-z_]\\w*)\\s*[\\[.]"));
    forEachStatement(main_, false, [&](const ScriptStatement& statement, bool inFunction) {
        isPendant_ = isPendant_ || statement.node > 0;
        if (statement.kind == ScriptStatement::Kind::Disabled) {
            for (int line = statement.first; line <= statement.last; ++line) {
                disabledLines_.insert(line);
            }
        }
        codes << statement.code;
        for (const ScriptStatement::Branch& branch : statement.branches) {
            codes << branch.condition;
        }
        functionSetsTcp_ = functionSetsTcp_ || (inFunction && callsSetTcp(statement.code));
        if (const auto changed = element.match(statement.code);
            statement.kind == ScriptStatement::Kind::Simple && changed.hasMatch()) {
            ++assignments[changed.captured(1)];
        }
        const auto match = assignment.match(statement.code);
        if (statement.kind == ScriptStatement::Kind::Simple && match.hasMatch()) {
            ++assignments[match.captured(2)];
            const bool isGlobal = match.captured(1).startsWith(QLatin1String("global"));
            if (isGlobal && !inFunction) {
                globals.insert(match.captured(2));
            }
            // An assignment before the `global` statement of the variable creates a local variable.
            const bool isLocal = inFunction || !globals.contains(match.captured(2));
            values.push_back({match.captured(2), match.captured(3).trimmed(), isGlobal, isLocal});
        }
    });
    types_ = variableTypes(values);
    for (const VariableAssignment& value : values) {
        if (value.isGlobal && !value.isLocal && assignments.value(value.name) == 1) {
            constants_.insert(value.name);
        }
    }
    code_ = codes.join(QLatin1Char('\n'));
}

int ScriptOutline::occurrences(const QString& word) const {
    static const QRegularExpression text(QStringLiteral("\"[^\"\\n]*\""));
    const QRegularExpression whole(QStringLiteral("\\b%1\\b").arg(QRegularExpression::escape(word)));
    return static_cast<int>(QString(code_).remove(text).count(whole));
}

QString ScriptOutline::textOf(const Statements& list) const {
    QStringList texts;
    for (const ScriptStatement& statement : list) {
        const QString text = textOf(statement);
        if (!text.isEmpty()) {
            texts << text;
        }
    }
    return texts.join(QLatin1Char('\n'));
}

QString ScriptOutline::textOf(const ScriptStatement& statement) const {
    static const QRegularExpression label(QStringLiteral("^\\s*\\$\\s*\\d+\\s*\".*\"\\s*$"));
    static const QRegularExpression notSpace(QStringLiteral("\\S"));
    if (statement.kind == ScriptStatement::Kind::Folder) {
        return textOf(statement.body);
    }
    const bool isMark = statement.kind == ScriptStatement::Kind::Disabled ||
                        statement.kind == ScriptStatement::Kind::Omitted ||
                        (statement.kind == ScriptStatement::Kind::Comment && statement.node > 0 &&
                         statement.last < statement.first);
    QStringList texts;
    qsizetype indent = std::numeric_limits<qsizetype>::max();
    for (int line = statement.first; !isMark && line <= statement.last; ++line) {
        const QString& text = lines_[line];
        if (!disabledLines_.contains(line) && !text.trimmed().isEmpty() && !label.match(text).hasMatch()) {
            indent = std::min(indent, text.indexOf(notSpace));
            texts << text;
        }
    }
    for (QString& text : texts) {
        text.remove(0, indent);
    }
    return texts.join(QLatin1Char('\n'));
}

}  // namespace tiller::program
