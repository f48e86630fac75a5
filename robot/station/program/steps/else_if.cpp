// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/branch.h"
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& elseIfStep() {
    static const StepKind kind{
        .id = "elseIf",
        .group = StepGroup::Flow,
        .name = [] { return ProgramText::tr("Else if"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("condition", ProgramText::tr("Condition"), FieldType::Expression)};
            },
        .write =
            [](StepWriter& writer) {
                writer.open(QStringLiteral("elif %1:").arg(writer.expression("condition")));
                writer.mark();
                writer.steps();
                closeBranch(writer, {"elseIf", "else"});
            },
        .isSection = true,
        .isMarker = true,
        .follows = {"if", "elseIf"},
    };
    return kind;
}

}  // namespace tiller::program
