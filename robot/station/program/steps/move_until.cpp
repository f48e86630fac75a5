// SPDX-License-Identifier: MIT
#include "robot/script/supervised_program.h"
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& moveUntilStep() {
    static const StepKind kind{
        .id = "moveUntil",
        .group = StepGroup::Motion,
        .name = [] { return ProgramText::tr("Move until"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    choiceField("until", ProgramText::tr("Until"),
                                {{"contact", ProgramText::tr("Contact")},
                                 {"input", ProgramText::tr("Input is on")},
                                 {"distance", ProgramText::tr("Distance")}}),
                    optionalField("input", ProgramText::tr("Input"), FieldType::DigitalInput),
                    choiceField("axes", ProgramText::tr("Reference frame"),
                                {{"tool", ProgramText::tr("Tool")},
                                 {"base", ProgramText::tr("Base")},
                                 {"frame", ProgramText::tr("Section frame")}}),
                    choiceField("direction", ProgramText::tr("Direction"),
                                {{"+z", QStringLiteral("+Z")},
                                 {"-z", QStringLiteral("-Z")},
                                 {"+x", QStringLiteral("+X")},
                                 {"-x", QStringLiteral("-X")},
                                 {"+y", QStringLiteral("+Y")},
                                 {"-y", QStringLiteral("-Y")}}),
                    numberField("distance", ProgramText::tr("Maximum distance"), Unit::Length, 0.0001, 2,
                                0.1),
                    numberField("speed", ProgramText::tr("Speed"), Unit::Speed, 0.0001, 0.5, 0.02),
                    otherwiseField(ProgramText::tr("If not reached"))};
            },
        .write =
            [](StepWriter& writer) {
                const QString until = writer.text("until");
                const QString direction = writer.text("direction");
                Eigen::Vector3d unit = Eigen::Vector3d::Zero();
                unit[direction.back().unicode() - 'x'] = direction.front() == QLatin1Char('-') ? -1 : 1;
                QString axis = scriptPose({unit, Eigen::Vector3d::Zero()});
                if (writer.text("axes") == QLatin1String("frame")) {
                    axis = scriptPose({rotationMatrix(writer.scope().T_base_frame.rotation) * unit,
                                       Eigen::Vector3d::Zero()});
                } else if (writer.text("axes") == QLatin1String("tool")) {
                    axis = QStringLiteral(
                               "pose_sub(pose_trans(get_target_tcp_pose(), %1), get_target_tcp_pose())")
                               .arg(axis);
                }
                if (until == QLatin1String("input") && !writer.has("input")) {
                    writer.error("input", ProgramText::tr("Select an input."));
                    return;
                }
                QString reached = QStringLiteral("False");
                if (until == QLatin1String("input")) {
                    reached = inputCall(writer.whole("input")) + QStringLiteral(" == True");
                } else if (until == QLatin1String("contact")) {
                    reached = QStringLiteral("tool_contact() > 0");
                }
                const QString n = QString::number(writer.number());
                const QString speed = scriptNumber(writer.toolSpeed(writer.number("speed")));
                writer.line(QStringLiteral("tiller_start_%1 = get_target_tcp_pose()").arg(n));
                writer.line(QStringLiteral("tiller_axis_%1 = %2").arg(n, axis));
                writer.line(QStringLiteral("tiller_reached_%1 = %2").arg(n, reached));
                writer.open(QStringLiteral("while not tiller_reached_%1 and point_dist(tiller_start_%1, "
                                           "get_target_tcp_pose()) < %2:")
                                .arg(n, scriptNumber(writer.number("distance"))));
                writer.line(QStringLiteral("speedl([%2 * tiller_axis_%1[0], %2 * tiller_axis_%1[1], %2 * "
                                           "tiller_axis_%1[2], 0, 0, 0], "
                                           "1.2, %3)")
                                .arg(n, speed, script::stepTimeText(writer.version())));
                writer.line(QStringLiteral("tiller_reached_%1 = %2").arg(n, reached));
                writer.close();
                writer.line(QStringLiteral("stopl(3)"));
                if (until != QLatin1String("distance")) {
                    writer.failIfChosen(
                        "otherwise", QStringLiteral("not tiller_reached_%1").arg(n),
                        until == QLatin1String("input")
                            ? ProgramText::tr("The input did not turn on within the maximum distance. Check "
                                              "the sensor and its wiring.")
                            : ProgramText::tr("No contact was detected within the maximum distance."));
                }
                writer.noteMove(std::nullopt, 0);
            },
        .moves = true,
        .takesTime = true,
        .partlyDone = [] { return ProgramText::tr("The move is only partly complete."); },
    };
    return kind;
}

}  // namespace tiller::program
