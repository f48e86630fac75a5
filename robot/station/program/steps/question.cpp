// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"
#include "robot/station/program/detail/variable_type.h"
#include "robot/station/program/expression.h"

namespace tiller::program {

const StepKind& questionStep() {
    static const StepKind kind{
        .id = "question",
        .group = StepGroup::Operator,
        .name = [] { return ProgramText::tr("Question"); },
        .fields =
            [] {
                return std::vector<StepField>{plainField("text", ProgramText::tr("Text"), FieldType::Text),
                                              plainField("variable", ProgramText::tr("Variable"),
                                                         FieldType::Variable, QStringLiteral("answer")),
                                              choiceField("type", ProgramText::tr("Type"),
                                                          {{"number", ProgramText::tr("Number")},
                                                           {"whole", ProgramText::tr("Whole number")},
                                                           {"flag", ProgramText::tr("True or false")},
                                                           {"text", ProgramText::tr("Text")}})};
            },
        .write =
            [](StepWriter& writer) {
                const QString type = writer.text("type");
                const char* request = type == QLatin1String("number")  ? "float"
                                      : type == QLatin1String("whole") ? "integer"
                                      : type == QLatin1String("flag")  ? "boolean"
                                                                       : "string";
                constexpr SoftwareVersion kFirst{5, 6, 0, 0};
                if (writer.version() < kFirst) {
                    writer.error("", ProgramText::tr("Questions require robot software 5.6 or newer."));
                }
                writer.declare(writer.text("variable"), variableType(type));
                writer.line(QStringLiteral("global %1 = request_%2_from_primary_client(%3)")
                                .arg(writer.text("variable"), QLatin1String(request),
                                     scriptString(writer.text("text"))));
            },
        .takesTime = true,
    };
    return kind;
}

}  // namespace tiller::program
