// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& leaveLoopStep() {
    static const StepKind kind{
        .id = "leaveLoop",
        .group = StepGroup::Flow,
        .name = [] { return ProgramText::tr("Exit loop"); },
        .fields = [] { return std::vector<StepField>{}; },
        .write =
            [](StepWriter& writer) {
                if (writer.scope().loops == 0) {
                    writer.error("", ProgramText::tr("“Exit loop” must be inside a loop."));
                }
                writer.line(QStringLiteral("break"));
            },
    };
    return kind;
}

}  // namespace tiller::program
