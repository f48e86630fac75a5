// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/branch.h"
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& caseStep() {
    static const StepKind kind{
        .id = "case",
        .group = StepGroup::Flow,
        .name = [] { return ProgramText::tr("Case"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("value", ProgramText::tr("Value"), FieldType::Expression)};
            },
        .write =
            [](StepWriter& writer) {
                const bool first = writer.previous() == nullptr;
                if (!first && QLatin1String(writer.previous()->id) == QLatin1String("default")) {
                    writer.error("", ProgramText::tr("“Default” must be the last branch of a Switch."));
                    return;
                }
                writer.open(QStringLiteral("%1 tiller_switch_%2 == %3:")
                                .arg(first ? "if" : "elif")
                                .arg(writer.parentNumber())
                                .arg(writer.expression("value")));
                writer.mark();
                writer.steps();
                closeBranch(writer, {"case", "default"});
            },
        .isSection = true,
        .isMarker = true,
        .inside = "switch",
    };
    return kind;
}

}  // namespace tiller::program
