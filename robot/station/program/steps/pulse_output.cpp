// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& pulseOutputStep() {
    static const StepKind kind{
        .id = "pulseOutput",
        .group = StepGroup::InputsOutputs,
        .name = [] { return ProgramText::tr("Pulse output"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("output", ProgramText::tr("Output"), FieldType::DigitalOutput, 0),
                    flagField("value", ProgramText::tr("On"), true),
                    numberField("time", ProgramText::tr("Time"), Unit::Time, 0.002, kMaxStepTime, 0.5)};
            },
        .write =
            [](StepWriter& writer) {
                writer.line(outputCall(writer.whole("output"), writer.flag("value")));
                writer.line(QStringLiteral("sleep(%1)").arg(scriptNumber(writer.number("time"))));
                writer.line(outputCall(writer.whole("output"), !writer.flag("value")));
            },
        .takesTime = true,
    };
    return kind;
}

}  // namespace tiller::program
