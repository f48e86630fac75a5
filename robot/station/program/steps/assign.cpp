// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"
#include "robot/station/program/detail/variable_type.h"

namespace tiller::program {

const StepKind& assignStep() {
    static const StepKind kind{
        .id = "assign",
        .group = StepGroup::Variables,
        .name = [] { return ProgramText::tr("Set variable"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("variable", ProgramText::tr("Variable"), FieldType::Variable),
                    choiceField("type", ProgramText::tr("Type"),
                                {{"number", ProgramText::tr("Number")},
                                 {"whole", ProgramText::tr("Whole number")},
                                 {"flag", ProgramText::tr("True or false")},
                                 {"text", ProgramText::tr("Text")},
                                 {"pose", ProgramText::tr("Pose")}}),
                    plainField("value", ProgramText::tr("Value"), FieldType::Expression)};
            },
        .write =
            [](StepWriter& writer) {
                writer.declare(writer.text("variable"), variableType(writer.text("type")));
                writer.line(QStringLiteral("global %1 = %2")
                                .arg(writer.text("variable"), writer.expression("value")));
            },
    };
    return kind;
}

}  // namespace tiller::program
