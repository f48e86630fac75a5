// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"
#include "robot/station/program/expression.h"

namespace tiller::program {

const StepKind& commentStep() {
    static const StepKind kind{
        .id = "comment",
        .group = StepGroup::Structure,
        .name = [] { return ProgramText::tr("Comment"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("text", ProgramText::tr("Text"), FieldType::Lines, {}, true)};
            },
        .write =
            [](StepWriter& writer) {
                for (const QString& line : writer.text("text").split(QLatin1Char('\n'))) {
                    writer.line(QStringLiteral("# ") + scriptComment(line));
                }
            },
        .isMarker = true,
    };
    return kind;
}

}  // namespace tiller::program
