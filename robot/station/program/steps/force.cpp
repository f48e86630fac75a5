// SPDX-License-Identifier: MIT
#include <algorithm>

#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& forceStep() {
    static const StepKind kind{
        .id = "force",
        .group = StepGroup::Tooling,
        .name = [] { return ProgramText::tr("Force section"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    choiceField("axes", ProgramText::tr("Reference frame"),
                                {{"tool", ProgramText::tr("Tool")},
                                 {"base", ProgramText::tr("Base")},
                                 {"frame", ProgramText::tr("Section frame")}}),
                    choiceField(
                        "axis", ProgramText::tr("Axis"),
                        {{"z", QStringLiteral("Z")}, {"x", QStringLiteral("X")}, {"y", QStringLiteral("Y")}}),
                    numberField("force", ProgramText::tr("Force"), Unit::Force, -200, 200, 10),
                    numberField("speed", ProgramText::tr("Speed limit"), Unit::Speed, 0.001, 0.5, 0.05)};
            },
        .write =
            [](StepWriter& writer) {
                constexpr double kPathDeviation = 0.1;       // [m] along the axes that are not compliant
                constexpr double kRotationDeviation = 0.17;  // [rad]
                const int axis = writer.text("axis").front().unicode() - 'x';
                QStringList selection;
                QStringList wrench;
                QStringList limits;
                for (int i = 0; i < 6; ++i) {
                    selection.append(i == axis ? QStringLiteral("1") : QStringLiteral("0"));
                    wrench.append(scriptNumber(i == axis ? writer.number("force") : 0));
                    limits.append(
                        scriptNumber(i == axis ? std::min(writer.number("speed"), writer.speedLimits().tool)
                                     : i < 3   ? kPathDeviation
                                               : kRotationDeviation));
                }
                const QString axes = writer.text("axes");
                const QString task = axes == QLatin1String("tool") ? QStringLiteral("get_actual_tcp_pose()")
                                     : axes == QLatin1String("base")
                                         ? scriptPose({})
                                         : scriptPose(writer.scope().T_base_frame);
                const auto list = [](const QStringList& values) {
                    return QStringLiteral("[%1]").arg(values.join(QStringLiteral(", ")));
                };
                writer.line(QStringLiteral("force_mode(%1, %2, %3, 2, %4)")
                                .arg(task, list(selection), list(wrench), list(limits)));
                writer.inScope([&] {
                    writer.scope().isForce = true;
                    writer.steps();
                });
                writer.line(QStringLiteral("end_force_mode()"));
            },
        .isSection = true,
        .cannotContinue =
            [] {
                return ProgramText::tr(
                    "The stop was inside a force section, so the contact cannot be restored.");
            },
    };
    return kind;
}

}  // namespace tiller::program
