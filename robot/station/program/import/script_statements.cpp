// SPDX-License-Identifier: MIT
#include "robot/station/program/import/script_statements.h"
#include "robot/station/program/program_text.h"

#include <QRegularExpression>
#include <cmath>

namespace tiller::program {

using simulator::pendant::NodeMark;

namespace {

constexpr int kMaxBlockDepth = 200;

/// The text with the contents of its strings replaced by spaces.
QString withoutStrings(const QString& text) {
    QString result = text;
    bool quoted = false;
    for (QChar& c : result) {
        if (c == QLatin1Char('"')) {
            quoted = !quoted;
        } else if (quoted) {
            c = QLatin1Char(' ');
        }
    }
    return result;
}

int bracketDepth(const QString& code) {
    int depth = 0;
    for (const QChar c : withoutStrings(code)) {
        depth += c == QLatin1Char('(') || c == QLatin1Char('[')   ? 1
                 : c == QLatin1Char(')') || c == QLatin1Char(']') ? -1
                                                                  : 0;
    }
    return depth;
}

struct BlockWords {
    int opening = 0;
    int closing = 0;
};

BlockWords blockWords(const QString& code) {
    static const QRegularExpression word(QStringLiteral("(?<![\\w.])(?:(def|sec|thread|if|while)|(end))\\b"));
    BlockWords words;
    for (auto it = word.globalMatch(withoutStrings(code)); it.hasNext();) {
        ++(it.next().captured(1).isEmpty() ? words.closing : words.opening);
    }
    return words;
}

class Splitter {
public:
    Splitter(const QStringList& lines, const std::vector<NodeMark>& marks) : lines_(lines), marks_(marks) {}

    Result<std::vector<ScriptStatement>> split() {
        std::vector<ScriptStatement> all;
        const End end = readBlock(all, 0);
        if (error_.isEmpty() && end != End::Text) {
            fail(ProgramText::tr("this line ends a block that was not opened"));
        }
        if (!error_.isEmpty()) {
            return Error{ErrorCode::ScriptError, error_, {}};
        }
        return all;
    }

private:
    enum class End { Text, End, Else, Mark };

    void fail(const QString& why) {
        if (error_.isEmpty()) {
            error_ = ProgramText::tr("line %1: %2").arg(line_ + 1).arg(why);
        }
    }

    ScriptStatement statement(ScriptStatement::Kind kind, int first, const QString& code) const {
        return {kind, first, first, code, node_, nodeName_, {}, {}};
    }

    /// Reads up to the end of the block; `branch_` is then the line that ended it.
    End readBlock(std::vector<ScriptStatement>& into, int depth) {
        if (depth > kMaxBlockDepth) {
            fail(ProgramText::tr("the blocks are nested too deeply"));
        }
        while (error_.isEmpty()) {
            if (mark_ < marks_.size() && marks_[mark_].line <= line_) {
                const NodeMark& mark = marks_[mark_++];
                if (mark.kind == NodeMark::Kind::FolderEnd || mark.kind == NodeMark::Kind::DisabledEnd) {
                    return End::Mark;
                }
                readMarked(mark, into, depth);
                continue;
            }
            if (line_ >= lines_.size()) {
                return End::Text;
            }
            if (const std::optional<End> end = readLine(into, depth)) {
                return *end;
            }
        }
        return End::Text;
    }

    void readMarked(const NodeMark& mark, std::vector<ScriptStatement>& into, int depth) {
        using Kind = ScriptStatement::Kind;
        node_ = mark.number;
        nodeName_ = mark.text;
        const bool isFolder = mark.kind == NodeMark::Kind::FolderBegin;
        ScriptStatement read = statement(isFolder                                     ? Kind::Folder
                                         : mark.kind == NodeMark::Kind::DisabledBegin ? Kind::Disabled
                                         : mark.kind == NodeMark::Kind::Comment       ? Kind::Comment
                                                                                      : Kind::Omitted,
                                         line_, mark.text);
        if (isFolder || mark.kind == NodeMark::Kind::DisabledBegin) {
            if (readBlock(read.body, depth + 1) != End::Mark) {
                fail(ProgramText::tr("a block extends beyond its node"));
            }
        }
        read.last = line_ - 1;
        into.push_back(std::move(read));
    }

    std::optional<End> readLine(std::vector<ScriptStatement>& into, int depth) {
        using Kind = ScriptStatement::Kind;
        static const QRegularExpression label(QStringLiteral("^\\$\\s*(\\d+)\\s*\"(.*)\"\\s*$"));
        static const QRegularExpression elif (QStringLiteral("^elif\\b(.*):$"));
        static const QRegularExpression header(QStringLiteral("^(def|sec|thread|if|while)\\b(.*):$"));
        const int first = line_;
        const QString raw = lines_[line_].trimmed();
        if (const auto match = label.match(raw); match.hasMatch()) {
            node_ = match.captured(1).toInt();
            nodeName_ = match.captured(2);
            ++line_;
            return std::nullopt;
        }
        QString code = codeOf(raw);
        ++line_;
        if (code.isEmpty()) {
            if (raw.startsWith(QLatin1Char('#'))) {
                into.push_back(statement(Kind::Comment, first, raw.mid(1).trimmed()));
            }
            return std::nullopt;
        }
        while (bracketDepth(code) > 0 && line_ < lines_.size() &&
               !(mark_ < marks_.size() && marks_[mark_].line <= line_)) {
            code += QLatin1Char(' ') + codeOf(lines_[line_++]);
        }
        branch_ = code;
        if (code == QLatin1String("end")) {
            return End::End;
        }
        const QString elseCode = code.simplified().remove(QLatin1Char(' '));
        if (elseCode == QLatin1String("else:") || elif.match(code).hasMatch()) {
            return End::Else;
        }
        const BlockWords words = blockWords(code);
        if (words.opening == words.closing) {
            static const QRegularExpression part(QStringLiteral("^(else|elif|end)\\b"));
            if (part.match(code).hasMatch()) {
                fail(ProgramText::tr("the line contains several statements"));
            }
            ScriptStatement simple = statement(Kind::Simple, first, code);
            simple.last = line_ - 1;
            into.push_back(std::move(simple));
            return std::nullopt;
        }
        const auto match = header.match(code);
        if (words.opening != 1 || words.closing != 0 || !match.hasMatch()) {
            fail(ProgramText::tr("the line contains several statements"));
            return std::nullopt;
        }
        const QString word = match.captured(1);
        ScriptStatement block = statement(word == QLatin1String("if")      ? Kind::If
                                          : word == QLatin1String("while") ? Kind::While
                                                                           : Kind::Function,
                                          first, match.captured(2).trimmed());
        if (block.kind == Kind::If) {
            readBranches(block, depth);
        } else {
            const int node = node_;
            const QString nodeName = nodeName_;
            if (block.kind == Kind::Function) {
                block.code = code;
            }
            if (readBlock(block.body, depth + 1) != End::End) {
                fail(ProgramText::tr("the block that begins on line %1 has no end").arg(first + 1));
            }
            node_ = node;
            nodeName_ = nodeName;
        }
        block.last = line_ - 1;
        into.push_back(std::move(block));
        return std::nullopt;
    }

    void readBranches(ScriptStatement& block, int depth) {
        block.branches.push_back({std::exchange(block.code, {}), {}});
        for (;;) {
            // Read into a separate vector, because reading a branch may move the existing branches.
            std::vector<ScriptStatement> body;
            const End end = readBlock(body, depth + 1);
            block.branches.back().body = std::move(body);
            if (end == End::End || !error_.isEmpty()) {
                return;
            }
            const bool wasElse = block.branches.size() > 1 && block.branches.back().condition.isEmpty();
            if (end != End::Else || wasElse) {
                fail(ProgramText::tr("the block that begins on line %1 has no end").arg(block.first + 1));
                return;
            }
            const bool isElse = branch_.startsWith(QLatin1String("else"));
            block.branches.push_back({isElse ? QString() : branch_.mid(4).chopped(1).trimmed(), {}});
        }
    }

    const QStringList& lines_;
    const std::vector<NodeMark>& marks_;
    int line_ = 0;
    std::size_t mark_ = 0;
    int node_ = 0;
    QString nodeName_;
    QString branch_;
    QString error_;
};

/// Splits at commas outside of brackets and strings. Returns no value if the brackets do not match.
std::optional<QStringList> splitArguments(const QString& text) {
    QStringList parts;
    const QString plain = withoutStrings(text);
    qsizetype begin = 0;
    int depth = 0;
    for (qsizetype i = 0; i < plain.size(); ++i) {
        const QChar c = plain[i];
        depth += c == QLatin1Char('(') || c == QLatin1Char('[')   ? 1
                 : c == QLatin1Char(')') || c == QLatin1Char(']') ? -1
                                                                  : 0;
        if (depth < 0) {
            return std::nullopt;
        }
        if (c == QLatin1Char(',') && depth == 0) {
            parts.append(text.mid(begin, i - begin).trimmed());
            begin = i + 1;
        }
    }
    if (depth != 0) {
        return std::nullopt;
    }
    const QString last = text.mid(begin).trimmed();
    if (!last.isEmpty() || !parts.isEmpty()) {
        parts.append(last);
    }
    return parts;
}

}  // namespace

Result<std::vector<ScriptStatement>> splitScript(const QStringList& lines,
                                                 const std::vector<NodeMark>& marks) {
    return Splitter(lines, marks).split();
}

QString codeOf(const QString& line) {
    const qsizetype comment = withoutStrings(line).indexOf(QLatin1Char('#'));
    return (comment < 0 ? line : line.left(comment)).trimmed();
}

std::optional<QStringList> ScriptCall::bind(const QStringList& names) const {
    QStringList values(names.size());
    for (qsizetype i = 0; i < static_cast<qsizetype>(arguments.size()); ++i) {
        const ScriptArgument& argument = arguments[static_cast<std::size_t>(i)];
        const qsizetype at = argument.name.isEmpty() ? i : names.indexOf(argument.name);
        if (at < 0 || at >= names.size() || !values[at].isNull() || argument.text.isEmpty()) {
            return std::nullopt;
        }
        values[at] = argument.text;
    }
    return values;
}

std::optional<ScriptCall> parseCall(const QString& code) {
    static const QRegularExpression start(QStringLiteral("^([A-Za-z_]\\w*)\\s*\\("));
    static const QRegularExpression named(QStringLiteral("^([A-Za-z_]\\w*)\\s*=(?!=)\\s*"));
    const auto match = start.match(code);
    if (!match.hasMatch() || !code.endsWith(QLatin1Char(')'))) {
        return std::nullopt;
    }
    const qsizetype open = match.capturedEnd();
    const auto parts = splitArguments(code.mid(open, code.size() - open - 1));
    if (!parts) {
        return std::nullopt;
    }
    ScriptCall call{match.captured(1), {}};
    for (const QString& part : *parts) {
        const auto name = named.match(part);
        call.arguments.push_back(name.hasMatch()
                                     ? ScriptArgument{name.captured(1), part.mid(name.capturedEnd())}
                                     : ScriptArgument{{}, part});
    }
    return call;
}

QString withoutBrackets(QString expression) {
    for (expression = expression.trimmed();
         expression.startsWith(QLatin1Char('(')) && expression.endsWith(QLatin1Char(')'));) {
        const QString inner = expression.mid(1, expression.size() - 2);
        if (!splitArguments(inner) || inner.trimmed().isEmpty()) {
            break;
        }
        expression = inner.trimmed();
    }
    return expression;
}

std::optional<double> numberLiteral(const QString& text) {
    static const QRegularExpression number(QStringLiteral("^[-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)?\\z"));
    const double value = text.toDouble();
    return number.match(text).hasMatch() && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<std::vector<double>> listLiteral(const QString& text, const QString& prefix, qsizetype count) {
    if (!text.startsWith(prefix + QLatin1Char('[')) || !text.endsWith(QLatin1Char(']'))) {
        return std::nullopt;
    }
    const QStringList parts =
        text.mid(prefix.size() + 1, text.size() - prefix.size() - 2).split(QLatin1Char(','));
    std::vector<double> values;
    for (const QString& part : parts) {
        if (const auto value = numberLiteral(part.trimmed())) {
            values.push_back(*value);
        }
    }
    return parts.size() == count && static_cast<qsizetype>(values.size()) == count ? std::optional(values)
                                                                                   : std::nullopt;
}

std::optional<QString> stringLiteral(const QString& text) {
    const bool isString = text.size() >= 2 && text.startsWith(QLatin1Char('"')) &&
                          text.indexOf(QLatin1Char('"'), 1) == text.size() - 1;
    return isString ? std::optional(text.mid(1, text.size() - 2)) : std::nullopt;
}

}  // namespace tiller::program
