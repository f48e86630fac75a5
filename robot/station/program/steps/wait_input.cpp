// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& waitInputStep() {
    static const StepKind kind{
        .id = "waitInput",
        .group = StepGroup::Wait,
        .name = [] { return ProgramText::tr("Wait for input"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("input", ProgramText::tr("Input"), FieldType::DigitalInput, 0),
                    flagField("value", ProgramText::tr("On"), true), timeLimitField(),
                    otherwiseField(ProgramText::tr("On timeout"))};
            },
        .write =
            [](StepWriter& writer) {
                const int input = writer.whole("input");
                const QString condition =
                    QStringLiteral("%1 == %2").arg(inputCall(input), scriptFlag(writer.flag("value")));
                writer.waitUntil(condition, writer.given("timeLimit"));
                if (writer.has("timeLimit")) {
                    writer.failIfChosen(
                        "otherwise", QStringLiteral("not (%1)").arg(condition),
                        ProgramText::tr("%1 did not change to the expected state before the timeout.")
                            .arg(channelName(input, false)));
                }
            },
        .takesTime = true,
    };
    return kind;
}

}  // namespace tiller::program
