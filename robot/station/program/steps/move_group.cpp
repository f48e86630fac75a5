// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/move_target.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& moveGroupStep() {
    static const StepKind kind{
        .id = "moveGroup",
        .group = StepGroup::Motion,
        .name = [] { return ProgramText::tr("Move through a group"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("group", ProgramText::tr("Group"), FieldType::Group),
                    flagField("actions", ProgramText::tr("Run waypoint actions"), true)};
            },
        .write =
            [](StepWriter& writer) {
                const QString group = writer.text("group");
                const project::WaypointList& points = writer.project().waypoints;
                int last = 0;
                for (int i = 0; i < points.size(); ++i) {
                    last = points.at(i).group == group ? i : last;
                }
                for (int i = 0; i < points.size(); ++i) {
                    const project::Waypoint& point = points.at(i);
                    if (point.group == group) {
                        writeMoveTo(writer,
                                    point.move == project::MoveKind::Joint ? MoveCommand::J : MoveCommand::L,
                                    point, i == last);
                    }
                }
            },
        .moves = true,
        .takesTime = true,
    };
    return kind;
}

}  // namespace tiller::program
