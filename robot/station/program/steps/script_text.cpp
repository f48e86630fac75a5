// SPDX-License-Identifier: MIT
#include <QRegularExpression>

#include "robot/station/program/detail/fields.h"
#include "robot/station/program/detail/step_kinds.h"
#include "robot/station/program/detail/step_writer.h"
#include "robot/station/program/expression.h"

namespace tiller::program {

const StepKind& scriptTextStep() {
    static const StepKind kind{
        .id = "script",
        .group = StepGroup::Structure,
        .name = [] { return ProgramText::tr("URScript"); },
        .fields =
            [] {
                return std::vector<StepField>{plainField("text", ProgramText::tr("Text"), FieldType::Lines)};
            },
        .write =
            [](StepWriter& writer) {
                const QString text = writer.text("text");
                if (text.contains(QLatin1String("tiller_"))) {
                    writer.error("text", ProgramText::tr("Names that begin with “tiller_” are reserved."));
                }
                if (!hasWholeBlocks(text)) {
                    writer.error("text", ProgramText::tr("Each block in the script needs an “end”."));
                }
                static const QRegularExpression kThread(QStringLiteral("\\bthread\\s+\\w+\\s*\\("));
                if (writer.scope().isParallel || text.contains(kThread)) {
                    writer.noteOwnThread();
                }
                for (const QString& line : text.split(QLatin1Char('\n'))) {
                    writer.line(line);
                }
                writer.noteMove(std::nullopt, 0);
                static const QRegularExpression kSetTcp(QStringLiteral("^set_tcp\\s*\\("),
                                                        QRegularExpression::MultilineOption);
                writer.scope().setsTcp =
                    writer.scope().setsTcp || (!writer.scope().isParallel && text.contains(kSetTcp));
            },
        .cannotContinue = [] { return ProgramText::tr("The URScript text was only partly executed."); },
    };
    return kind;
}

}  // namespace tiller::program
