// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& gripperStep() {
    static const StepKind kind{
        .id = "gripper",
        .group = StepGroup::Tooling,
        .name = [] { return ProgramText::tr("Gripper"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    choiceField("action", ProgramText::tr("Action"),
                                {{"close", ProgramText::tr("Close")}, {"open", ProgramText::tr("Open")}}),
                    plainField("closeOutput", ProgramText::tr("Closing output"), FieldType::DigitalOutput,
                               16),
                    optionalField("openOutput", ProgramText::tr("Opening output"), FieldType::DigitalOutput),
                    numberField("time", ProgramText::tr("Time"), Unit::Time, 0, 60, 0.5),
                    optionalField("input", ProgramText::tr("Input to check"), FieldType::DigitalInput),
                    otherwiseField(ProgramText::tr("If the input is off"))};
            },
        .write =
            [](StepWriter& writer) {
                const bool closes = writer.text("action") == QLatin1String("close");
                if (writer.has("openOutput")) {
                    if (writer.whole("openOutput") == writer.whole("closeOutput")) {
                        writer.error("openOutput",
                                     ProgramText::tr("Select different outputs for opening and closing."));
                    }
                    writer.line(outputCall(writer.whole(closes ? "openOutput" : "closeOutput"), false));
                    writer.line(outputCall(writer.whole(closes ? "closeOutput" : "openOutput"), true));
                } else {
                    writer.line(outputCall(writer.whole("closeOutput"), closes));
                }
                if (writer.number("time") > 0) {
                    writer.line(QStringLiteral("sleep(%1)").arg(scriptNumber(writer.number("time"))));
                }
                if (writer.has("input")) {
                    writer.failIfChosen("otherwise",
                                        QStringLiteral("not %1").arg(inputCall(writer.whole("input"))),
                                        ProgramText::tr("The gripper is not holding an object."));
                }
            },
    };
    return kind;
}

}  // namespace tiller::program
