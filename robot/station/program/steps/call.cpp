// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

namespace {

/// Counts the arguments separated by commas, except commas inside brackets.
qsizetype argumentCount(const QString& arguments) {
    qsizetype depth = 0;
    qsizetype commas = 0;
    bool quoted = false;
    for (const QChar c : arguments) {
        quoted = quoted != (c == QLatin1Char('"'));
        if (!quoted) {
            depth += c == QLatin1Char('(') || c == QLatin1Char('[')   ? 1
                     : c == QLatin1Char(')') || c == QLatin1Char(']') ? -1
                                                                      : 0;
            commas += c == QLatin1Char(',') && depth == 0 ? 1 : 0;
        }
    }
    return arguments.isEmpty() ? 0 : commas + 1;
}

}  // namespace

const StepKind& callStep() {
    static const StepKind kind{
        .id = "call",
        .group = StepGroup::Flow,
        .name = [] { return ProgramText::tr("Call program"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("program", ProgramText::tr("Program"), FieldType::Program),
                    optionalField("arguments", ProgramText::tr("Parameter values"), FieldType::Expression)};
            },
        .write =
            [](StepWriter& writer) {
                const project::Program& called = *writer.project().programs.find(writer.id("program"));
                const QString arguments =
                    writer.has("arguments") ? writer.expression("arguments") : QString();
                if (const qsizetype values = argumentCount(arguments); values != called.parameters.size()) {
                    writer.error(
                        "arguments",
                        ProgramText::tr(
                            "The program “%1” requires %2 comma-separated values, but the step passes %3.")
                            .arg(called.name)
                            .arg(called.parameters.size())
                            .arg(values));
                    return;
                }
                const QString function = writer.programFunction(called.id);
                if (function.isEmpty()) {
                    return;
                }
                const QString result = QStringLiteral("tiller_result_%1").arg(writer.number());
                writer.line(QStringLiteral("%1 = %2(%3)").arg(result, function, arguments));
                writer.open(QStringLiteral("if %1 != \"\":").arg(result));
                writer.failWith(result);
                writer.close();
                writer.markReturn();
            },
    };
    return kind;
}

}  // namespace tiller::program
