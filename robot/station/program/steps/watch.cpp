// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& watchStep() {
    static const StepKind kind{
        .id = "watch",
        .group = StepGroup::Flow,
        .name = [] { return ProgramText::tr("Watch in parallel"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("condition", ProgramText::tr("Condition"), FieldType::Expression)};
            },
        .write =
            [](StepWriter& writer) {
                if (!writer.scope().isTop) {
                    writer.error(
                        "", ProgramText::tr("A parallel watch must be at the top level of the program."));
                    return;
                }
                const QString name = QStringLiteral("tiller_watch_%1").arg(writer.number());
                const QString condition = writer.expression("condition");
                writer.function(QStringLiteral("thread %1():").arg(name), [&] {
                    writer.scope().isParallel = true;
                    writer.scope().isTop = false;
                    writer.open(QStringLiteral("while True:"));
                    writer.waitUntil(condition, std::nullopt);
                    writer.steps();
                    writer.waitUntil(QStringLiteral("not (%1)").arg(condition), std::nullopt);
                    writer.line(QStringLiteral("sync()"));
                    writer.close();
                });
                writer.line(QStringLiteral("tiller_thread_%1 = run %2()").arg(writer.number()).arg(name));
            },
        .isSection = true,
    };
    return kind;
}

}  // namespace tiller::program
