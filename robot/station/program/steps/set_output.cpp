// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& setOutputStep() {
    static const StepKind kind{
        .id = "setOutput",
        .group = StepGroup::InputsOutputs,
        .name = [] { return ProgramText::tr("Set output"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("output", ProgramText::tr("Output"), FieldType::DigitalOutput, 0),
                    flagField("value", ProgramText::tr("On"), true)};
            },
        .write =
            [](StepWriter& writer) { writer.line(outputCall(writer.whole("output"), writer.flag("value"))); },
    };
    return kind;
}

}  // namespace tiller::program
