// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/loop_body.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& loopStep() {
    static const StepKind kind{
        .id = "loop",
        .group = StepGroup::Flow,
        .name = [] { return ProgramText::tr("Loop"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    wholeField("times", ProgramText::tr("Repetitions (0: endless)"), 0, 1'000'000, 2),
                    optionalField("variable", ProgramText::tr("Counter"), FieldType::Variable)};
            },
        .write =
            [](StepWriter& writer) {
                const int times = writer.whole("times");
                const QString counter = QStringLiteral("tiller_loop_%1").arg(writer.number());
                writer.line(counter + QStringLiteral(" = 0"));
                writer.open(times == 0 ? QStringLiteral("while True:")
                                       : QStringLiteral("while %1 < %2:").arg(counter).arg(times));
                if (times == 0) {
                    writer.countCycle(counter);
                } else {
                    writer.line(QStringLiteral("%1 = %1 + 1").arg(counter));
                }
                if (writer.has("variable")) {
                    writer.declare(writer.text("variable"), VariableType::Whole);
                    writer.line(QStringLiteral("global %1 = %2").arg(writer.text("variable"), counter));
                }
                writer.inScope([&] {
                    writer.scope().isCycle = writer.scope().isCycle || times == 0;
                    writeLoopBody(writer, times == 0);
                });
                writer.close();
            },
        .isSection = true,
    };
    return kind;
}

}  // namespace tiller::program
