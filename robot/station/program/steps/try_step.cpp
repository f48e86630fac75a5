// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

namespace {

bool hasKind(const std::vector<project::ProgramStep>& steps, const char* kind) {
    return std::any_of(steps.begin(), steps.end(), [&](const project::ProgramStep& step) {
        return step.kind == QLatin1String(kind) || hasKind(step.steps, kind);
    });
}

}  // namespace

const StepKind& tryStep() {
    static const StepKind kind{
        .id = "try",
        .group = StepGroup::Flow,
        .name = [] { return ProgramText::tr("Try"); },
        .fields = [] { return std::vector<StepField>{}; },
        .write =
            [](StepWriter& writer) {
                if (writer.next() == nullptr ||
                    QLatin1String(writer.next()->id) != QLatin1String("onError")) {
                    writer.error("", ProgramText::tr("“Try” must be followed directly by “On error”."));
                }
                const int n = writer.number();
                writer.function(QStringLiteral("def tiller_try_%1():").arg(n), [&] {
                    writer.scope().isFunction = true;
                    writer.scope().loops = 0;
                    writer.steps();
                    writer.line(QStringLiteral("return \"\""));
                });
                writer.declare(QStringLiteral("tiller_error"), VariableType::Text);
                writer.line(QStringLiteral("tiller_tcp_%1 = get_tcp_offset()").arg(n));
                writer.line(QStringLiteral("global tiller_error = tiller_try_%1()").arg(n));
                writer.open(QStringLiteral("if tiller_error != \"\":"));
                writer.line(QStringLiteral("set_tcp(tiller_tcp_%1)").arg(n));
                if (hasKind(writer.step().steps, "force")) {
                    writer.line(QStringLiteral("end_force_mode()"));
                }
                writer.close();
            },
        .isSection = true,
    };
    return kind;
}

}  // namespace tiller::program
