// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& frameStep() {
    static const StepKind kind{
        .id = "frame",
        .group = StepGroup::Tooling,
        .name = [] { return ProgramText::tr("Frame section"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("frame", ProgramText::tr("Frame"), FieldType::Frame)};
            },
        .write =
            [](StepWriter& writer) {
                writer.inScope([&] {
                    writer.scope().T_base_frame =
                        writer.project().frames.pose(writer.id("frame")).value_or(Pose());
                    writer.steps();
                });
            },
        .isSection = true,
    };
    return kind;
}

}  // namespace tiller::program
