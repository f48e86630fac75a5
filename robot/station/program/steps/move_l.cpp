// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/move_target.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& moveLStep() {
    static const StepKind kind{
        .id = "moveL",
        .group = StepGroup::Motion,
        .name = [] { return ProgramText::tr("MoveL"); },
        .fields = [] { return moveFields(MoveCommand::L); },
        .write = [](StepWriter& writer) { writeMove(writer, MoveCommand::L); },
        .moves = true,
        .takesTime = true,
    };
    return kind;
}

}  // namespace tiller::program
