// SPDX-License-Identifier: MIT
#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"
#include "robot/station/program/expression.h"

namespace tiller::program {

const StepKind& folderStep() {
    static const StepKind kind{
        .id = "folder",
        .group = StepGroup::Structure,
        .name = [] { return ProgramText::tr("Folder"); },
        .fields =
            [] {
                return std::vector<StepField>{
                    plainField("name", ProgramText::tr("Name"), FieldType::Text, {}, true)};
            },
        .write =
            [](StepWriter& writer) {
                if (writer.has("name")) {
                    writer.line(QStringLiteral("# ") + scriptComment(writer.text("name")));
                }
                writer.steps();
            },
        .isSection = true,
    };
    return kind;
}

}  // namespace tiller::program
