// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/loop_body.h"

#include <algorithm>

#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/move_target.h"

namespace tiller::program {
namespace {

/// With more poses, one function of the script would take longer than a control period.
constexpr std::size_t kMaxPlaces = 1000;

bool mayTakeTime(const std::vector<project::ProgramStep>& steps) {
    return std::any_of(steps.begin(), steps.end(), [](const project::ProgramStep& step) {
        const StepKind* kind = findStepKind(step.kind);
        // A called program or a script may wait or leave the loop.
        const bool isOpaque = step.kind == QLatin1String("call") || step.kind == QLatin1String("script") ||
                              step.kind == QLatin1String("leaveLoop") || step.kind == QLatin1String("end") ||
                              step.kind == QLatin1String("fail");
        return !step.disabled &&
               (isOpaque || (kind != nullptr && kind->takesTime) || mayTakeTime(step.steps));
    });
}

}  // namespace

void writeLoopBody(StepWriter& writer, bool mayNotEnd) {
    const std::vector<project::ProgramStep>& steps = writer.step().steps;
    if (mayNotEnd && !mayTakeTime(steps)) {
        writer.error("", ProgramText::tr("This loop may never end and contains no delay. Add a Wait step."));
    }
    writer.inScope([&] {
        ++writer.scope().loops;
        writer.steps();
    });
    const bool alwaysTakesTime =
        std::any_of(steps.begin(), steps.end(), [](const project::ProgramStep& step) {
            const StepKind* kind = findStepKind(step.kind);
            return !step.disabled && kind != nullptr && kind->takesTime && kind->moves;
        });
    if (!alwaysTakesTime) {
        writer.line(QStringLiteral("sync()"));
    }
}

void writePlaceLoop(StepWriter& writer, const std::vector<project::Waypoint>& places, const char* key) {
    if (places.empty() || places.size() > kMaxPlaces) {
        writer.error(key, ProgramText::tr("A loop can have 1 to %1 positions; this loop has %2.")
                              .arg(kMaxPlaces)
                              .arg(places.size()));
        return;
    }
    const QString n = QString::number(writer.number());
    writer.function(QStringLiteral("def tiller_place_%1(index):").arg(n), [&] {
        for (std::size_t i = 0; i < places.size(); ++i) {
            const auto target = targetAt(writer, places[i], 0, key);
            if (!target) {
                return;
            }
            if (i + 1 < places.size()) {
                writer.open(QStringLiteral("if index == %1:").arg(i));
                writer.line(QStringLiteral("return %1").arg(target->pose));
                writer.close();
            } else {
                writer.line(QStringLiteral("return %1").arg(target->pose));
            }
        }
    });
    const QString counter = QStringLiteral("tiller_loop_%1").arg(n);
    writer.declare(writer.text("variable"), VariableType::Pose);
    writer.line(counter + QStringLiteral(" = 0"));
    writer.open(QStringLiteral("while %1 < %2:").arg(counter).arg(places.size()));
    writer.line(QStringLiteral("global %1 = tiller_place_%2(%3)").arg(writer.text("variable"), n, counter));
    writer.line(QStringLiteral("%1 = %1 + 1").arg(counter));
    writeLoopBody(writer, false);
    writer.close();
}

}  // namespace tiller::program
