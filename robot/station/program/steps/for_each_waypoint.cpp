// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/loop_body.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& forEachWaypointStep() {
    static const StepKind kind{
        .id = "forEachWaypoint",
        .group = StepGroup::Flow,
        .name = [] { return ProgramText::tr("For each waypoint"); },
        .fields =
            [] {
                return std::vector<StepField>{plainField("group", ProgramText::tr("Group"), FieldType::Group),
                                              plainField("variable", ProgramText::tr("Pose"),
                                                         FieldType::Variable, QStringLiteral("place"))};
            },
        .write =
            [](StepWriter& writer) {
                std::vector<project::Waypoint> points;
                for (const project::Waypoint& point : writer.project().waypoints) {
                    if (point.group == writer.text("group")) {
                        points.push_back(point);
                    }
                }
                writePlaceLoop(writer, points, "group");
            },
        .isSection = true,
    };
    return kind;
}

}  // namespace tiller::program
