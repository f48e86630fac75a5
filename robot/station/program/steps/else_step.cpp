// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/branch.h"
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& elseStep() {
    static const StepKind kind{
        .id = "else",
        .group = StepGroup::Flow,
        .name = [] { return ProgramText::tr("Else"); },
        .fields = [] { return std::vector<StepField>{}; },
        .write =
            [](StepWriter& writer) {
                writer.open(QStringLiteral("else:"));
                writer.mark();
                writer.steps();
                closeBranch(writer, {});
            },
        .isSection = true,
        .isMarker = true,
        .follows = {"if", "elseIf"},
    };
    return kind;
}

}  // namespace tiller::program
