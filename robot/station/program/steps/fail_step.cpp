// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& failStep() {
    static const StepKind kind{
        .id = "fail",
        .group = StepGroup::Flow,
        .name = [] { return ProgramText::tr("Fail"); },
        .fields =
            [] {
                return std::vector<StepField>{plainField("text", ProgramText::tr("Text"), FieldType::Text,
                                                         ProgramText::tr("The program failed."))};
            },
        .write = [](StepWriter& writer) { writer.fail(writer.text("text")); },
    };
    return kind;
}

}  // namespace tiller::program
