// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& setAnalogOutputStep() {
    static const StepKind kind{
        .id = "setAnalogOutput",
        .group = StepGroup::InputsOutputs,
        .name = [] { return ProgramText::tr("Set analog output"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    wholeField("output", ProgramText::tr("Output"), 0, 1, 0),
                    numberField("level", ProgramText::tr("Level"), Unit::Percent, 0, 1, 0)};
            },
        .write =
            [](StepWriter& writer) {
                writer.line(QStringLiteral("set_standard_analog_out(%1, %2)")
                                .arg(writer.whole("output"))
                                .arg(scriptNumber(writer.number("level"))));
            },
    };
    return kind;
}

}  // namespace tiller::program
