// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QFileInfo>

#include "robot/recording/formats/file_formats.h"

namespace tiller::app {
namespace {

/// Translation context of this file for lupdate.
struct CommandLineText {
    Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

struct Row {
    const char* name;
    const char* value;  ///< name of the value in the help; empty if the option has no value
    const char* text;
    bool isHidden = false;  ///< true for an option name of earlier versions
};

constexpr char kProjectText[] = QT_TRANSLATE_NOOP("CommandLine", "Open this project file (.tiller).");

/// All options except those of Qt. The parser, the help and the shell completions are generated from this
/// table.
constexpr Row kRows[] = {
    {"simulator", "", QT_TRANSLATE_NOOP("CommandLine", "Start with the built-in simulated UR5e.")},
    {"robot", "host", QT_TRANSLATE_NOOP("CommandLine", "Connect to the robot at this address or host name.")},
    {"demo", "folder",
     QT_TRANSLATE_NOOP("CommandLine",
                       "Run the scripted demonstration on the simulated robot, write its files to this "
                       "folder, and exit.")},
    {"project", "file", kProjectText},
    {"session", "file", kProjectText, true},
    {"theme", "name", QT_TRANSLATE_NOOP("CommandLine", "Colour theme: light or dark.")},
    {"monitor-only", "",
     QT_TRANSLATE_NOOP("CommandLine",
                       "Monitor only: do not change anything on the robot; STOP still works. Cannot be "
                       "turned off in Settings.")},
};

QCommandLineOption optionOf(const Row& row) {
    QCommandLineOption option(row.name, CommandLineText::tr(row.text), row.value);
    if (row.isHidden) {
        option.setFlags(QCommandLineOption::HiddenFromHelp);
    }
    return option;
}

/// E.g. "file.csv|file.mcap".
QString recordingNames() {
    QStringList names;
    for (const recording::FileFormat& format : recording::fileFormats()) {
        names << QStringLiteral("file.") + format.suffixes.constFirst();
    }
    return names.join(QLatin1Char('|'));
}

}  // namespace

bool isRecordingName(const QString& path) {
    return recording::fileFormatOf(path) != nullptr;
}

Result<CommandLine> parseCommandLine(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        CommandLineText::tr("Jog, teach, run and monitor a Universal Robots arm from a PC."));
    const QCommandLineOption help = parser.addHelpOption();
    const QCommandLineOption version = parser.addVersionOption();
    for (const Row& row : kRows) {
        parser.addOption(optionOf(row));
    }
    parser.addPositionalArgument("file", CommandLineText::tr(kProjectText), "[file.tiller]");
    parser.addPositionalArgument("recording", CommandLineText::tr("Open these recordings in the plots."),
                                 QStringLiteral("[%1 ...]").arg(recordingNames()));

    const auto wrong = [&](const QString& what) {
        return Error{ErrorCode::InvalidArgument, what, CommandLineText::tr("see tiller --help")};
    };
    if (!parser.parse(arguments)) {
        return wrong(parser.errorText());
    }
    // File managers pass files as positional arguments.
    QStringList files = parser.positionalArguments();
    const bool opened = !files.isEmpty() && files.constFirst().endsWith(QLatin1String(".tiller"));
    const QString file = opened ? files.takeFirst() : QString();
    CommandLine line;
    while (!files.isEmpty() && isRecordingName(files.constFirst())) {
        line.recordings.append(files.takeFirst());
    }
    if (!files.isEmpty()) {
        return wrong(CommandLineText::tr("unexpected argument \"%1\"").arg(files.constFirst()));
    }
    if (opened && parser.isSet("project")) {
        return wrong(CommandLineText::tr("only one project can be opened; remove \"%1\"").arg(file));
    }

    line.showHelp = parser.isSet(help);
    line.showVersion = parser.isSet(version);
    line.helpText = parser.helpText();
    line.demoDirectory = parser.value("demo");
    line.projectFile = opened ? file : parser.value(parser.isSet("project") ? "project" : "session");
    line.theme = parser.value("theme").toLower();
    if (!line.theme.isEmpty() && line.theme != "light" && line.theme != "dark") {
        return wrong(CommandLineText::tr("--theme must be light or dark, not \"%1\"").arg(line.theme));
    }
    line.monitorOnly = parser.isSet("monitor-only");
    if (parser.isSet("demo") && line.monitorOnly) {
        return wrong(CommandLineText::tr(
            "--demo moves the simulated robot and cannot be combined with --monitor-only"));
    }
    if (parser.isSet("robot") && parser.isSet("simulator")) {
        return wrong(CommandLineText::tr("--robot and --simulator cannot be combined"));
    }
    if (parser.isSet("demo") && parser.isSet("robot")) {
        // The demonstration moves the arm automatically, so it must not run on a real robot.
        return wrong(CommandLineText::tr(
            "--demo works only on the simulated robot and cannot be combined with --robot"));
    }
    if (parser.isSet("demo") && line.demoDirectory.isEmpty()) {
        return wrong(CommandLineText::tr("--demo requires a folder"));
    }
    if (parser.isSet("robot")) {
        line.robotHost = parser.value("robot").trimmed();
        if (line.robotHost.isEmpty()) {
            return wrong(CommandLineText::tr("--robot requires an address, e.g. --robot 192.168.0.10"));
        }
        line.start = CommandLine::Start::Robot;
    } else if (parser.isSet("simulator") || parser.isSet("demo")) {
        line.start = CommandLine::Start::Simulator;
    }
    return line;
}

}  // namespace tiller::app
