// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"
#include "robot/station/program/program_script.h"

namespace tiller::program {

const StepKind& endProgramStep() {
    static const StepKind kind{
        .id = "end",
        .group = StepGroup::Flow,
        .name = [] { return ProgramText::tr("End program"); },
        .fields = [] { return std::vector<StepField>{}; },
        .write =
            [](StepWriter& writer) {
                writer.line(QStringLiteral("write_output_integer_register(%1, 0)").arg(kStepRegister));
                writer.line(QStringLiteral("halt"));
            },
    };
    return kind;
}

}  // namespace tiller::program
