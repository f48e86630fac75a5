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
    const QCommandLineOption simulator("simulator",
                                       CommandLineText::tr("Start with the built-in simulated UR5e."));
    const QCommandLineOption robot(
        "robot", CommandLineText::tr("Connect to the robot at this address or host name."), "host");
    const QCommandLineOption demo("demo",
                                  CommandLineText::tr("Run the scripted demonstration on the simulated "
                                                      "robot, write its files to this folder, and exit."),
                                  "folder");
    const QCommandLineOption project("project", CommandLineText::tr("Open this project file (.tiller)."),
                                     "file");
    // Name of the option in earlier versions.
    QCommandLineOption session("session", project.description(), "file");
    session.setFlags(QCommandLineOption::HiddenFromHelp);
    const QCommandLineOption theme("theme", CommandLineText::tr("Colour theme: light or dark."), "name");
    const QCommandLineOption monitorOnly(
        "monitor-only", CommandLineText::tr("Monitor only: do not change anything on the robot; STOP still "
                                            "works. Cannot be turned off in Settings."));
    parser.addPositionalArgument("file", project.description(), "[file.tiller]");
    parser.addPositionalArgument("recording", CommandLineText::tr("Open these recordings in the plots."),
                                 "[file.mcap|file.h5|file.csv ...]");
    parser.addOptions({simulator, robot, demo, project, session, theme, monitorOnly});

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
    if (opened && parser.isSet(project)) {
        return wrong(CommandLineText::tr("only one project can be opened; remove \"%1\"").arg(file));
    }

    line.showHelp = parser.isSet(help);
    line.showVersion = parser.isSet(version);
    line.helpText = parser.helpText();
    line.demoDirectory = parser.value(demo);
    line.projectFile = opened ? file : parser.value(parser.isSet(project) ? project : session);
    line.theme = parser.value(theme).toLower();
    if (!line.theme.isEmpty() && line.theme != "light" && line.theme != "dark") {
        return wrong(CommandLineText::tr("--theme must be light or dark, not \"%1\"").arg(line.theme));
    }
    line.monitorOnly = parser.isSet(monitorOnly);
    if (parser.isSet(demo) && line.monitorOnly) {
        return wrong(CommandLineText::tr(
            "--demo moves the simulated robot and cannot be combined with --monitor-only"));
    }
    if (parser.isSet(robot) && parser.isSet(simulator)) {
        return wrong(CommandLineText::tr("--robot and --simulator cannot be combined"));
    }
    if (parser.isSet(demo) && parser.isSet(robot)) {
        // The demonstration moves the arm automatically, so it must not run on a real robot.
        return wrong(CommandLineText::tr(
            "--demo works only on the simulated robot and cannot be combined with --robot"));
    }
    if (parser.isSet(demo) && line.demoDirectory.isEmpty()) {
        return wrong(CommandLineText::tr("--demo requires a folder"));
    }
    if (parser.isSet(robot)) {
        line.robotHost = parser.value(robot).trimmed();
        if (line.robotHost.isEmpty()) {
            return wrong(CommandLineText::tr("--robot requires an address, e.g. --robot 192.168.0.10"));
        }
        line.start = CommandLine::Start::Robot;
    } else if (parser.isSet(simulator) || parser.isSet(demo)) {
        line.start = CommandLine::Start::Simulator;
    }
    return line;
}

}  // namespace tiller::app
