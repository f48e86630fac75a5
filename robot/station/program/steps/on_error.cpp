// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& onErrorStep() {
    static const StepKind kind{
        .id = "onError",
        .group = StepGroup::Flow,
        .name = [] { return ProgramText::tr("On error"); },
        .fields = [] { return std::vector<StepField>{}; },
        .write =
            [](StepWriter& writer) {
                writer.open(QStringLiteral("if tiller_error != \"\":"));
                writer.mark();
                writer.steps();
                writer.close();
            },
        .isSection = true,
        .isMarker = true,
        .follows = {"try"},
    };
    return kind;
}

}  // namespace tiller::program
