// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& waitConditionStep() {
    static const StepKind kind{
        .id = "waitCondition",
        .group = StepGroup::Wait,
        .name = [] { return ProgramText::tr("Wait for condition"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("condition", ProgramText::tr("Condition"), FieldType::Expression),
                    timeLimitField(), otherwiseField(ProgramText::tr("On timeout"))};
            },
        .write =
            [](StepWriter& writer) {
                const QString condition = writer.expression("condition");
                writer.waitUntil(condition, writer.given("timeLimit"));
                if (writer.has("timeLimit")) {
                    writer.failIfChosen(
                        "otherwise", QStringLiteral("not (%1)").arg(condition),
                        ProgramText::tr("The condition did not become true before the timeout."));
                }
            },
        .takesTime = true,
    };
    return kind;
}

}  // namespace tiller::program
