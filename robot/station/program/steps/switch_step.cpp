// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& switchStep() {
    static const StepKind kind{
        .id = "switch",
        .group = StepGroup::Flow,
        .name = [] { return ProgramText::tr("Switch"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("value", ProgramText::tr("Value"), FieldType::Expression)};
            },
        .write =
            [](StepWriter& writer) {
                const bool hasCase =
                    std::any_of(writer.step().steps.begin(), writer.step().steps.end(),
                                [](const project::ProgramStep& step) {
                                    return !step.disabled && step.kind == QLatin1String("case");
                                });
                if (!hasCase) {
                    writer.error("", ProgramText::tr("A Switch must contain at least one Case."));
                }
                for (const project::ProgramStep& step : writer.step().steps) {
                    if (!step.disabled && step.kind != QLatin1String("case") &&
                        step.kind != QLatin1String("default") && step.kind != QLatin1String("comment")) {
                        writer.error(
                            "", ProgramText::tr("Only Case and Default can be placed directly in a Switch."));
                        return;
                    }
                }
                writer.line(QStringLiteral("tiller_switch_%1 = %2")
                                .arg(writer.number())
                                .arg(writer.expression("value")));
                writer.steps();
            },
        .isSection = true,
    };
    return kind;
}

}  // namespace tiller::program
