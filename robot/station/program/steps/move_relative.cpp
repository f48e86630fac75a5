// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& moveRelativeStep() {
    static const StepKind kind{
        .id = "moveRelative",
        .group = StepGroup::Motion,
        .name = [] { return ProgramText::tr("Relative move"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    choiceField("axes", ProgramText::tr("Reference frame"),
                                {{"tool", ProgramText::tr("Tool")},
                                 {"base", ProgramText::tr("Base")},
                                 {"frame", ProgramText::tr("Section frame")}}),
                    numberField("x", ProgramText::tr("X"), Unit::Length, -3, 3, 0),
                    numberField("y", ProgramText::tr("Y"), Unit::Length, -3, 3, 0),
                    numberField("z", ProgramText::tr("Z"), Unit::Length, -3, 3, 0),
                    numberField("speed", ProgramText::tr("Speed"), Unit::Speed, 0.0001, 3, 0.1),
                    numberField("acceleration", ProgramText::tr("Acceleration"), Unit::Acceleration, 0.001,
                                15, 1.2)};
            },
        .write =
            [](StepWriter& writer) {
                const Eigen::Vector3d offset(writer.number("x"), writer.number("y"), writer.number("z"));
                if (offset.isZero()) {
                    writer.error("z", ProgramText::tr("The distance is zero. Enter a value for X, Y or Z."));
                }
                const QString axes = writer.text("axes");
                QString target = QStringLiteral("pose_trans(get_target_tcp_pose(), %1)")
                                     .arg(scriptPose({offset, Eigen::Vector3d::Zero()}));
                if (axes != QLatin1String("tool")) {
                    const Eigen::Vector3d base =
                        axes == QLatin1String("base")
                            ? offset
                            : rotationMatrix(writer.scope().T_base_frame.rotation) * offset;
                    target = QStringLiteral("pose_add(get_target_tcp_pose(), %1)")
                                 .arg(scriptPose({base, Eigen::Vector3d::Zero()}));
                }
                writer.line(QStringLiteral("movel(%1, a=%2, v=%3)")
                                .arg(target, scriptNumber(writer.number("acceleration")),
                                     scriptNumber(writer.toolSpeed(writer.number("speed")))));
                writer.noteMove(std::nullopt, 0);
            },
        .moves = true,
        .takesTime = true,
        .partlyDone = [] { return ProgramText::tr("The relative move is only partly complete."); },
    };
    return kind;
}

}  // namespace tiller::program
