// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"
#include "robot/station/program/program_script.h"

namespace tiller::program {

const StepKind& setRegisterStep() {
    static const StepKind kind{
        .id = "setRegister",
        .group = StepGroup::InputsOutputs,
        .name = [] { return ProgramText::tr("Set register"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    choiceField("type", ProgramText::tr("Type"),
                                {{"integer", ProgramText::tr("Integer")},
                                 {"float", ProgramText::tr("Float")},
                                 {"boolean", ProgramText::tr("Boolean")}}),
                    wholeField("register", ProgramText::tr("Register"), 0, 127, 0),
                    plainField("value", ProgramText::tr("Value"), FieldType::Expression)};
            },
        .write =
            [](StepWriter& writer) {
                const QString type = writer.text("type");
                const int number = writer.whole("register");
                if (type != QLatin1String("boolean") && number >= script::kGateRegister) {
                    writer.error("register", ProgramText::tr("Programs can set registers only up to %1.")
                                                 .arg(script::kGateRegister - 1));
                }
                writer.line(QStringLiteral("write_output_%1_register(%2, %3)")
                                .arg(type)
                                .arg(number)
                                .arg(writer.expression("value")));
            },
    };
    return kind;
}

}  // namespace tiller::program
