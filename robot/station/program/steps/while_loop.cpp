// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/loop_body.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& whileLoopStep() {
    static const StepKind kind{
        .id = "while",
        .group = StepGroup::Flow,
        .name = [] { return ProgramText::tr("While"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("condition", ProgramText::tr("Condition"), FieldType::Expression)};
            },
        .write =
            [](StepWriter& writer) {
                writer.open(QStringLiteral("while %1:").arg(writer.expression("condition")));
                writeLoopBody(writer, true);
                writer.close();
            },
        .isSection = true,
    };
    return kind;
}

}  // namespace tiller::program
