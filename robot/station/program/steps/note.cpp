// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"
#include "robot/station/program/expression.h"

namespace tiller::program {

const StepKind& noteStep() {
    static const StepKind kind{
        .id = "log",
        .group = StepGroup::Operator,
        .name = [] { return ProgramText::tr("Write to the log"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("text", ProgramText::tr("Text"), FieldType::Text),
                    optionalField("value", ProgramText::tr("Value"), FieldType::Expression)};
            },
        .write =
            [](StepWriter& writer) {
                const QString text = scriptString(writer.text("text"));
                writer.line(writer.has("value")
                                ? QStringLiteral("textmsg(%1, %2)").arg(text, writer.expression("value"))
                                : QStringLiteral("textmsg(%1)").arg(text));
            },
    };
    return kind;
}

}  // namespace tiller::program
