// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/move_target.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& movePStep() {
    static const StepKind kind{
        .id = "moveP",
        .group = StepGroup::Motion,
        .name = [] { return ProgramText::tr("MoveP"); },
        .fields = [] { return moveFields(MoveCommand::P); },
        .write = [](StepWriter& writer) { writeMove(writer, MoveCommand::P); },
        .moves = true,
        .takesTime = true,
    };
    return kind;
}

}  // namespace tiller::program
