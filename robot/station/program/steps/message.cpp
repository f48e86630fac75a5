// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"
#include "robot/station/program/expression.h"

namespace tiller::program {

const StepKind& messageStep() {
    static const StepKind kind{
        .id = "message",
        .group = StepGroup::Operator,
        .name = [] { return ProgramText::tr("Message"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("text", ProgramText::tr("Text"), FieldType::Text),
                    choiceField("level", ProgramText::tr("Severity"),
                                {{"message", ProgramText::tr("Message")},
                                 {"warning", ProgramText::tr("Warning")},
                                 {"error", ProgramText::tr("Error")}}),
                    flagField("waits", ProgramText::tr("Wait for the operator"), true)};
            },
        .write =
            [](StepWriter& writer) {
                const QString level = writer.text("level");
                writer.line(
                    QStringLiteral("popup(%1, title=\"Tiller\", warning=%2, error=%3, blocking=%4)")
                        .arg(scriptString(writer.text("text")), scriptFlag(level == QLatin1String("warning")),
                             scriptFlag(level == QLatin1String("error")), scriptFlag(writer.flag("waits"))));
            },
    };
    return kind;
}

}  // namespace tiller::program
