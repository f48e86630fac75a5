// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/branch.h"
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& ifStep() {
    static const StepKind kind{
        .id = "if",
        .group = StepGroup::Flow,
        .name = [] { return ProgramText::tr("If"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("condition", ProgramText::tr("Condition"), FieldType::Expression)};
            },
        .write =
            [](StepWriter& writer) {
                writer.open(QStringLiteral("if %1:").arg(writer.expression("condition")));
                writer.steps();
                closeBranch(writer, {"elseIf", "else"});
            },
        .isSection = true,
    };
    return kind;
}

}  // namespace tiller::program
