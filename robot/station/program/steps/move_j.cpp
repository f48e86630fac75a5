// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/move_target.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& moveJStep() {
    static const StepKind kind{
        .id = "moveJ",
        .group = StepGroup::Motion,
        .name = [] { return ProgramText::tr("MoveJ"); },
        .fields = [] { return moveFields(MoveCommand::J); },
        .write = [](StepWriter& writer) { writeMove(writer, MoveCommand::J); },
        .moves = true,
        .takesTime = true,
    };
    return kind;
}

}  // namespace tiller::program
