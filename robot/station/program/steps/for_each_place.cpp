// SPDX-License-Identifier: MIT
#include "robot/project/pattern.h"
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/loop_body.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& forEachPlaceStep() {
    static const StepKind kind{
        .id = "forEachPlace",
        .group = StepGroup::Flow,
        .name = [] { return ProgramText::tr("For each pattern cell"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("pattern", ProgramText::tr("Pattern"), FieldType::Pattern),
                    plainField("variable", ProgramText::tr("Pose"), FieldType::Variable,
                               QStringLiteral("place"))};
            },
        .write =
            [](StepWriter& writer) {
                const project::Pattern& pattern = *writer.project().patterns.find(writer.id("pattern"));
                writePlaceLoop(writer, project::waypointsOf(pattern, writer.model(), writer.project().frames),
                               "pattern");
            },
        .isSection = true,
    };
    return kind;
}

}  // namespace tiller::program
