// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& toolStep() {
    static const StepKind kind{
        .id = "tool",
        .group = StepGroup::Tooling,
        .name = [] { return ProgramText::tr("TCP section"); },
        .fields =
            [] {
                return std::vector<StepField>{plainField("tool", ProgramText::tr("Tool"), FieldType::Tool)};
            },
        .write =
            [](StepWriter& writer) {
                const project::Tool& tool = *writer.project().tooling.tools.find(writer.id("tool"));
                writer.line(QStringLiteral("tiller_tcp_%1 = get_tcp_offset()").arg(writer.number()));
                writer.line(QStringLiteral("set_tcp(%1)").arg(scriptPose(tool.tcpOffset)));
                writer.inScope([&] {
                    writer.scope().tcp = tool.tcpOffset;
                    writer.steps();
                });
                writer.line(QStringLiteral("set_tcp(tiller_tcp_%1)").arg(writer.number()));
            },
        .isSection = true,
    };
    return kind;
}

}  // namespace tiller::program
