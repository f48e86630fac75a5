// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& waitStep() {
    static const StepKind kind{
        .id = "wait",
        .group = StepGroup::Wait,
        .name = [] { return ProgramText::tr("Wait"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    numberField("time", ProgramText::tr("Time"), Unit::Time, 0.002, kMaxStepTime, 1)};
            },
        .write =
            [](StepWriter& writer) {
                writer.line(QStringLiteral("sleep(%1)").arg(scriptNumber(writer.number("time"))));
            },
        .takesTime = true,
    };
    return kind;
}

}  // namespace tiller::program
