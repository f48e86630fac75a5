// SPDX-License-Identifier: GPL-3.0-or-later

#include <QFile>

#include "app/cli_command.h"
#include "app/cli_program.h"
#include "robot/core/atomic_file.h"

namespace tiller::app {

namespace {

int script(const CommandArguments& arguments) {
    if (arguments.operands().size() != 1) {
        return wrongArguments(QStringLiteral("script: one project file is required"));
    }
    bool isNumber = false;
    const int first = arguments.value("from").toInt(&isNumber);
    if (!isNumber || first < 0) {
        return wrongArguments(
            QStringLiteral("--from must be a step number, not '%1'").arg(arguments.value("from")));
    }
    const auto loaded = loadProgram(arguments.operands().constFirst(), arguments.value("program"), first);
    if (!loaded) {
        return complain(loaded.error().toString(), kFailed);
    }
    for (const program::ProgramProblem& problem : loaded->script.problems) {
        complain(problemText(*loaded, problem.number, problem.text), kFailed);
    }
    if (!loaded->script.ok()) {
        return kFailed;
    }
    if (arguments.isSet("out")) {
        const auto written = writeFileAtomically(arguments.value("out"), loaded->script.text.toUtf8());
        return written ? kSuccess : complain(written.error().toString(), kFailed);
    }
    out() << loaded->script.text;
    out().flush();
    return kSuccess;
}

}  // namespace

const Command& scriptCommand() {
    static const Command kCommand{
        .name = "script",
        .operands = "FILE",
        .summary = "writes a program of a project as URScript",
        .title = "writes a program of a project as URScript",
        .usage = {"FILE.tiller [options]"},
        .options = {{"program", "NAME",
                     "name of the program; not needed if the project has only one program"},
                    {"from", "STEP", "starts at the step with this number", "0"},
                    {"out", "FILE", "writes to this file instead of standard output"}},
        .notes =
            "The script runs on the robot without a PC, so this PC cannot stop the script. Exit code: 0 the "
            "script was written, 1 the program has errors or the file cannot be read or written, 2 invalid "
            "arguments.",
        .run = script};
    return kCommand;
}

}  // namespace tiller::app
