// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"

namespace tiller::program {

const StepKind& payloadStep() {
    static const StepKind kind{
        .id = "payload",
        .group = StepGroup::Tooling,
        .name = [] { return ProgramText::tr("Set payload"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("payload", ProgramText::tr("Payload"), FieldType::Payload)};
            },
        .write =
            [](StepWriter& writer) {
                const project::Payload& payload =
                    *writer.project().tooling.payloads.find(writer.id("payload"));
                const QString centre =
                    QStringLiteral("[%1, %2, %3]")
                        .arg(scriptNumber(payload.centre.x()), scriptNumber(payload.centre.y()),
                             scriptNumber(payload.centre.z()));
                writer.line(QStringLiteral("set_payload(%1, %2)").arg(scriptNumber(payload.mass), centre));
            },
    };
    return kind;
}

}  // namespace tiller::program
