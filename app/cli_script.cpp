// SPDX-License-Identifier: GPL-3.0-or-later

#include <QCommandLineParser>
#include <QFile>

#include "app/cli_command.h"
#include "app/cli_program.h"
#include "robot/core/atomic_file.h"

namespace tiller::app {

namespace {

const QString kScriptHelp = QStringLiteral(
    "tiller-cli script: writes a program of a project as URScript\n"
    "\n"
    "Usage: tiller-cli script FILE.tiller [options]\n"
    "\n"
    "  --program NAME       name of the program; not needed if the project has only one\n"
    "  --from STEP          starts at the step with this number\n"
    "  --out FILE           writes to this file instead of standard output\n"
    "  --help               shows this text\n"
    "\n"
    "The script runs on the robot without a PC, so this PC cannot stop it. Exit code: 0 written, 1 the\n"
    "program has errors or the file cannot be read or written, 2 invalid arguments.\n");

}  // namespace

int script(const QStringList& arguments) {
    QCommandLineParser parser;
    const QCommandLineOption help(QStringList{"h", "help"});
    const QCommandLineOption name("program", {}, "NAME");
    const QCommandLineOption from("from", {}, "STEP", "0");
    const QCommandLineOption outFile("out", {}, "FILE");
    parser.addOptions({help, name, from, outFile});
    if (!parser.parse(arguments)) {
        return wrongArguments(parser.errorText());
    }
    if (parser.isSet(help)) {
        out() << kScriptHelp;
        out().flush();
        return kSuccess;
    }
    if (parser.positionalArguments().size() != 1) {
        return wrongArguments(QStringLiteral("script: one project file is required"));
    }
    bool isNumber = false;
    const int first = parser.value(from).toInt(&isNumber);
    if (!isNumber || first < 0) {
        return wrongArguments(
            QStringLiteral("--from must be a step number, not '%1'").arg(parser.value(from)));
    }
    const auto loaded = loadProgram(parser.positionalArguments().constFirst(), parser.value(name), first);
    if (!loaded) {
        return complain(loaded.error().toString(), kFailed);
    }
    for (const program::ProgramProblem& problem : loaded->script.problems) {
        complain(problemText(*loaded, problem.number, problem.text), kFailed);
    }
    if (!loaded->script.ok()) {
        return kFailed;
    }
    if (parser.isSet(outFile)) {
        const auto written = writeFileAtomically(parser.value(outFile), loaded->script.text.toUtf8());
        return written ? kSuccess : complain(written.error().toString(), kFailed);
    }
    out() << loaded->script.text;
    out().flush();
    return kSuccess;
}

}  // namespace tiller::app
