// SPDX-License-Identifier: MIT
#include "robot/station/program/expression.h"

#include <QRegularExpression>
#include <QSet>

#include "robot/station/program/program_text.h"

namespace tiller::program {
namespace {

/// Keywords that are not permitted as values.
const QSet<QString>& statementWords() {
    static const QSet<QString> words{QStringLiteral("def"),          QStringLiteral("sec"),
                                     QStringLiteral("thread"),       QStringLiteral("end"),
                                     QStringLiteral("if"),           QStringLiteral("elif"),
                                     QStringLiteral("else"),         QStringLiteral("while"),
                                     QStringLiteral("break"),        QStringLiteral("continue"),
                                     QStringLiteral("return"),       QStringLiteral("halt"),
                                     QStringLiteral("pause"),        QStringLiteral("run"),
                                     QStringLiteral("join"),         QStringLiteral("kill"),
                                     QStringLiteral("global"),       QStringLiteral("local"),
                                     QStringLiteral("struct"),       QStringLiteral("enter_critical"),
                                     QStringLiteral("exit_critical")};
    return words;
}

const QSet<QString>& valueWords() {
    static const QSet<QString> words{QStringLiteral("and"),  QStringLiteral("or"),   QStringLiteral("not"),
                                     QStringLiteral("xor"),  QStringLiteral("True"), QStringLiteral("False"),
                                     QStringLiteral("true"), QStringLiteral("false")};
    return words;
}

/// Converts "DI3" to a function call. Empty if the text is not a terminal label.
QString terminalCall(const QString& word) {
    static const QRegularExpression label(QStringLiteral("^([DCT])([IO])([0-7])$|^A([IO])([01])$"));
    const QRegularExpressionMatch match = label.match(word);
    if (!match.hasMatch()) {
        return {};
    }
    if (!match.captured(4).isEmpty()) {
        return QStringLiteral("get_standard_analog_%1(%2)")
            .arg(match.captured(4) == QLatin1String("I") ? "in" : "out", match.captured(5));
    }
    const QChar group = match.captured(1).front();
    if (group == QLatin1Char('T') && match.captured(3).toInt() > 1) {
        return {};
    }
    return QStringLiteral("get_%1_digital_%2(%3)")
        .arg(group == QLatin1Char('D')   ? "standard"
             : group == QLatin1Char('C') ? "configurable"
                                         : "tool",
             match.captured(2) == QLatin1String("I") ? "in" : "out", match.captured(3));
}

Expression failed(const QString& why) {
    return {{}, why};
}

}  // namespace

Expression parseExpression(const QString& text) {
    static const QRegularExpression token(
        QStringLiteral("(\\s+)|(\"[^\"\\n]*\")|([A-Za-z_]\\w*)|(\\d+\\.?\\d*(?:[eE][-+]?\\d+)?|\\.\\d+)|"
                       "(==|!=|<=|>=|[-+*/%<>(),.\\[\\]])"));
    if (text.trimmed().isEmpty()) {
        return failed(ProgramText::tr("The expression is empty. Enter an expression."));
    }
    if (text.contains(QLatin1Char('\n')) || text.contains(QLatin1Char('\r'))) {
        return failed(ProgramText::tr("An expression must be a single line."));
    }
    Expression result;
    QString open;
    bool followsDot = false;
    for (qsizetype at = 0; at < text.size();) {
        const QRegularExpressionMatch match = token.match(text, at, QRegularExpression::NormalMatch,
                                                          QRegularExpression::AnchorAtOffsetMatchOption);
        if (!match.hasMatch() || match.capturedLength() == 0) {
            return failed(ProgramText::tr("Unexpected character “%1”. Remove this character.").arg(text[at]));
        }
        at = match.capturedEnd();
        const QString word = match.captured(3);
        const QString sign = match.captured(5);
        if (!word.isEmpty()) {
            if (statementWords().contains(word)) {
                return failed(
                    ProgramText::tr("“%1” cannot be part of an expression. Remove this word.").arg(word));
            }
            const QString call = followsDot ? QString() : terminalCall(word);
            if (!call.isEmpty()) {
                result.script += call;
            } else if (word == QLatin1String("true") || word == QLatin1String("false")) {
                result.script +=
                    word == QLatin1String("true") ? QStringLiteral("True") : QStringLiteral("False");
            } else {
                result.script += word;
            }
        } else {
            if (sign == QLatin1String("(") || sign == QLatin1String("[")) {
                open += sign;
            } else if (sign == QLatin1String(")") || sign == QLatin1String("]")) {
                const QString wanted = sign == QLatin1String(")") ? QStringLiteral("(") : QStringLiteral("[");
                if (!open.endsWith(wanted)) {
                    return failed(ProgramText::tr("The brackets do not match. Add or remove a bracket."));
                }
                open.chop(1);
            }
            result.script += match.captured(0);
        }
        followsDot = sign == QLatin1String(".");
    }
    if (!open.isEmpty()) {
        return failed(ProgramText::tr("The brackets do not match. Add or remove a bracket."));
    }
    result.script = result.script.trimmed();
    return result;
}

bool hasWholeBlocks(const QString& script) {
    static const QRegularExpression text(QStringLiteral("\"[^\"\\n]*\"|#[^\\n]*"));
    static const QRegularExpression word(QStringLiteral("(?<![\\w.])(?:(def|sec|thread|if|while)|(end))\\b"));
    int depth = 0;
    for (auto it = word.globalMatch(QString(script).remove(text)); it.hasNext() && depth >= 0;) {
        depth += it.next().captured(1).isEmpty() ? -1 : 1;
    }
    return depth == 0;
}

bool isVariableName(const QString& name, QString* why) {
    static const QRegularExpression identifier(QStringLiteral("^[A-Za-z_][A-Za-z0-9_]*\\z"));
    QString reason;
    if (!identifier.match(name).hasMatch()) {
        reason = ProgramText::tr(
                     "“%1” is not a valid variable name. Use letters, digits and underscores, and do not "
                     "start with a digit.")
                     .arg(name);
    } else if (name.startsWith(QLatin1String("tiller_")) || statementWords().contains(name) ||
               valueWords().contains(name) || !terminalCall(name).isEmpty()) {
        reason = ProgramText::tr("The name “%1” is reserved. Use a different name.").arg(name);
    }
    if (why != nullptr) {
        *why = reason;
    }
    return reason.isEmpty();
}

QString scriptString(const QString& text) {
    QString result = text;
    result.replace(QRegularExpression(QStringLiteral("[\\r\\n\\t]+")), QStringLiteral(" "));
    result.replace(QLatin1Char('"'), QLatin1Char('\''));
    result.remove(QLatin1Char('\\'));
    return QLatin1Char('"') + result + QLatin1Char('"');
}

QString scriptComment(const QString& text) {
    QString result;
    for (const QChar c : text.simplified().normalized(QString::NormalizationForm_D)) {
        if (c.unicode() >= ' ' && c.unicode() <= '~') {
            result += c;
        }
    }
    return result;
}

QString scriptName(const QString& text) {
    QString result;
    for (const QChar c : text.normalized(QString::NormalizationForm_D)) {
        if (c.unicode() < 128 && c.isLetterOrNumber()) {
            result += c.toLower();
        } else if (!result.isEmpty() && !result.endsWith(QLatin1Char('_'))) {
            result += QLatin1Char('_');
        }
    }
    while (result.endsWith(QLatin1Char('_'))) {
        result.chop(1);
    }
    return result.isEmpty() || result.front().isDigit() ? QStringLiteral("program_") + result : result;
}

}  // namespace tiller::program
