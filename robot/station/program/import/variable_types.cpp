// SPDX-License-Identifier: MIT
#include "robot/station/program/import/variable_types.h"

#include <QRegularExpression>
#include <QSet>

#include "robot/station/program/import/script_statements.h"

namespace tiller::program {

namespace {

QString typeOfCall(const QString& function) {
    static const QSet<QString> poses{QStringLiteral("pose_trans"),
                                     QStringLiteral("pose_add"),
                                     QStringLiteral("pose_sub"),
                                     QStringLiteral("pose_inv"),
                                     QStringLiteral("interpolate_pose"),
                                     QStringLiteral("get_forward_kin"),
                                     QStringLiteral("get_actual_tcp_pose"),
                                     QStringLiteral("get_target_tcp_pose")};
    static const QRegularExpression flags(QStringLiteral(
        "^(get_(standard|configurable|tool)_digital_(in|out)|read_(in|out)put_boolean_register|"
        "request_boolean_from_primary_client)$"));
    static const QRegularExpression wholes(
        QStringLiteral("^(read_(in|out)put_integer_register|request_integer_from_primary_client)$"));
    static const QRegularExpression numbers(
        QStringLiteral("^(get_(standard|tool)_analog_(in|out)|read_(in|out)put_float_register|"
                       "request_float_from_primary_client)$"));
    return poses.contains(function)                                          ? QStringLiteral("pose")
           : flags.match(function).hasMatch()                                ? QStringLiteral("flag")
           : wholes.match(function).hasMatch()                               ? QStringLiteral("whole")
           : numbers.match(function).hasMatch()                              ? QStringLiteral("number")
           : function == QLatin1String("request_string_from_primary_client") ? QStringLiteral("text")
                                                                             : QString();
}

/// Sums, differences and products of numbers and variables.
QString typeOfArithmetic(const QString& expression, const QHash<QString, QString>& variables) {
    static const QRegularExpression token(QStringLiteral(
        "\\s*(?:(\\d+)(?![\\d.eE])|(\\d*\\.?\\d+(?:[eE][-+]?\\d+)?|\\d+\\.)|([A-Za-z_]\\w*)(?!\\w|"
        "\\s*[(\\[])|([-+*()]))\\s*"));
    bool isNumber = false;
    for (qsizetype at = 0; at < expression.size();) {
        const auto match = token.match(expression, at, QRegularExpression::NormalMatch,
                                       QRegularExpression::AnchorAtOffsetMatchOption);
        if (!match.hasMatch() || match.capturedLength() == 0) {
            return {};
        }
        at = match.capturedEnd();
        const QString type = match.captured(3).isEmpty() ? QString() : variables.value(match.captured(3));
        if (!match.captured(3).isEmpty() && type != QLatin1String("whole") &&
            type != QLatin1String("number")) {
            return {};
        }
        isNumber = isNumber || !match.captured(2).isEmpty() || type == QLatin1String("number");
    }
    return isNumber ? QStringLiteral("number") : QStringLiteral("whole");
}

}  // namespace

QString typeOf(const QString& expression, const QHash<QString, QString>& variables) {
    static const QRegularExpression logic(QStringLiteral("\\b(and|or|xor|not)\\b|==|!=|<|>"));
    const QString text = withoutBrackets(expression);
    if (text == QLatin1String("True") || text == QLatin1String("False")) {
        return QStringLiteral("flag");
    }
    if (stringLiteral(text)) {
        return QStringLiteral("text");
    }
    if (listLiteral(text, QStringLiteral("p"), 6)) {
        return QStringLiteral("pose");
    }
    if (const auto call = parseCall(text)) {
        return typeOfCall(call->function);
    }
    if (text.contains(logic) && !text.contains(QLatin1Char('[')) && !text.contains(QLatin1Char('"'))) {
        // A comparison in the argument of a call does not determine the type of the expression.
        static const QRegularExpression inCall(QStringLiteral("\\w\\s*\\([^()]*(<|>|==|!=)[^()]*\\)"));
        static const QRegularExpression notCall(QStringLiteral("\\b(and|or|xor|not)\\s*\\("));
        return QString(text).replace(notCall, QStringLiteral(" (")).contains(inCall) ? QString()
                                                                                     : QStringLiteral("flag");
    }
    if (const auto known = variables.constFind(text); known != variables.constEnd()) {
        return *known;
    }
    return typeOfArithmetic(text, variables);
}

QHash<QString, QString> variableTypes(const std::vector<VariableAssignment>& assignments) {
    QSet<QString> globals, excluded;
    for (const VariableAssignment& assignment : assignments) {
        (assignment.isGlobal ? globals : excluded)
            .insert(assignment.isGlobal || assignment.isLocal ? assignment.name : QString());
    }
    QHash<QString, QString> types;
    for (bool changed = true; changed;) {
        changed = false;
        for (const VariableAssignment& assignment : assignments) {
            if (types.contains(assignment.name) || !globals.contains(assignment.name) ||
                excluded.contains(assignment.name)) {
                continue;
            }
            const QString type = typeOf(assignment.value, types);
            if (!type.isEmpty()) {
                types.insert(assignment.name, type);
                changed = true;
            }
        }
    }
    // A type is uncertain if one assignment contradicts it, or if it depends on an uncertain type.
    for (bool changed = true; changed;) {
        changed = false;
        for (const VariableAssignment& assignment : assignments) {
            const auto known = types.constFind(assignment.name);
            if (known != types.constEnd() && typeOf(assignment.value, types) != *known) {
                types.remove(assignment.name);
                changed = true;
            }
        }
    }
    return types;
}

}  // namespace tiller::program
