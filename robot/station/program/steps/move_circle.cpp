// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/move_target.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& moveCircleStep() {
    static const StepKind kind{
        .id = "moveCircle",
        .group = StepGroup::Motion,
        .name = [] { return ProgramText::tr("MoveC"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("via", ProgramText::tr("Via"), FieldType::Waypoint),
                    plainField("waypoint", ProgramText::tr("To"), FieldType::Waypoint),
                    optionalNumber("speed", ProgramText::tr("Speed"), Unit::Speed, 0.0001, 3),
                    optionalNumber("acceleration", ProgramText::tr("Acceleration"), Unit::Acceleration, 0.001,
                                   15),
                    numberField("blend", ProgramText::tr("Blend"), Unit::Length, 0, 1, 0),
                    choiceField(
                        "orientation", ProgramText::tr("Orientation"),
                        {{"free", ProgramText::tr("Free")}, {"fixed", ProgramText::tr("Fixed to arc")}})};
            },
        .write =
            [](StepWriter& writer) {
                const project::Waypoint& to = waypointOf(writer, "waypoint");
                const auto via = targetAt(writer, waypointOf(writer, "via"), 0, "via");
                const auto end = targetAt(writer, to, 0, "waypoint");
                if (!via || !end) {
                    return;
                }
                writer.line(
                    QStringLiteral("movec(%1, %2, a=%3, v=%4, r=%5, mode=%6)")
                        .arg(via->pose, end->pose,
                             scriptNumber(
                                 writer.given("acceleration").value_or(project::kDefaultToolAcceleration)),
                             scriptNumber(writer.toolSpeed(writer.given("speed").value_or(to.toolSpeed))),
                             scriptNumber(writer.number("blend")),
                             writer.text("orientation") == QLatin1String("fixed") ? QStringLiteral("1")
                                                                                  : QStringLiteral("0")));
                writer.noteMove(end->known, writer.number("blend"));
            },
        .moves = true,
        .takesTime = true,
    };
    return kind;
}

}  // namespace tiller::program
