// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& speedStep() {
    static const StepKind kind{
        .id = "speed",
        .group = StepGroup::Tooling,
        .name = [] { return ProgramText::tr("Speed section"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    numberField("factor", ProgramText::tr("Speed"), Unit::Percent, 0.01, 1, 0.5)};
            },
        .write =
            [](StepWriter& writer) {
                writer.inScope([&] {
                    writer.scope().speedFactor *= writer.number("factor");
                    writer.steps();
                });
            },
        .isSection = true,
    };
    return kind;
}

}  // namespace tiller::program
