// SPDX-License-Identifier: GPL-3.0-or-later
//
// tiller-cli: what Tiller can do without a window. Links the backend only, which proves that the backend
// stands on its own.

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QHostAddress>
#include <QTextStream>

#include "app/termination.h"
#include "robot/simulator/controller.h"
#include "tiller_version.h"

using namespace tiller;

namespace {

enum ExitCode { kSuccess = 0, kFailed = 1, kWrongArguments = 2 };

QTextStream& out() {
    static QTextStream stream(stdout);
    return stream;
}

int wrongArguments(const QString& what) {
    QTextStream(stderr) << "tiller-cli: " << what << "\nSee 'tiller-cli --help'.\n";
    return kWrongArguments;
}

const QString kSimulateHelp = QStringLiteral(
    "tiller-cli simulate: a robot controller with a simulated arm, on the standard ports\n"
    "\n"
    "Usage: tiller-cli simulate [options]\n"
    "\n"
    "  --listen ADDRESS     address to listen on (default 127.0.0.1). Several controllers run side by\n"
    "                       side on 127.0.0.2, 127.0.0.3... Nothing beyond this machine can connect\n"
    "                       unless ADDRESS is one of the network's, or 0.0.0.0.\n"
    "  --port-offset N      added to every port number (default 0)\n"
    "  --model MODEL        ur3, ur3e, ur5, ur5e, ur10, ur10e, ur16e, ur20, ur30... (default ur5e)\n"
    "  --software VERSION   controller software to be, for example 5.22 (default 5.22.1; 3.15.8 for a\n"
    "                       CB3 model)\n"
    "  --headless           start with the brakes released and in remote control, ready to move\n"
    "  --programs FOLDER    where the dashboard's 'load' finds programs (URScript text)\n"
    "  --priority N         run at SCHED_FIFO priority N, 1 to 99, if the system permits\n"
    "  --help               this text\n"
    "\n"
    "Prints one line beginning with 'ready' once all ports accept. Ends on Ctrl-C or SIGTERM.\n");

const QString kHelp = QStringLiteral(
    "tiller-cli: Tiller without a window\n"
    "\n"
    "Usage: tiller-cli COMMAND [options]\n"
    "\n"
    "Commands:\n"
    "  simulate             run a simulated robot controller (see 'tiller-cli simulate --help')\n"
    "\n"
    "Options:\n"
    "  --help               this text\n"
    "  --version            the version of Tiller\n");

/// "5.22" or "5.22.1" or "5.22.1.1214193".
std::optional<SoftwareVersion> parseSoftware(const QString& text) {
    const QStringList parts = text.split('.');
    std::uint32_t numbers[4] = {0, 0, 0, 0};
    if (parts.size() < 2 || parts.size() > 4) {
        return std::nullopt;
    }
    for (qsizetype i = 0; i < parts.size(); ++i) {
        bool ok = false;
        numbers[i] = parts[i].toUInt(&ok);
        if (!ok) {
            return std::nullopt;
        }
    }
    const SoftwareVersion version{numbers[0], numbers[1], numbers[2], numbers[3]};
    const bool known = version.major == 3 || version.major == 5;
    return known ? std::optional(version) : std::nullopt;
}

QString modelNames() {
    QStringList names;
    for (const RobotModel& model : robotModels()) {
        names << QString::fromLatin1(model.name).toLower();
    }
    return names.join(QStringLiteral(", "));
}

int runController(const simulator::ControllerOptions& options) {
    app::holdTerminationSignals();
    simulator::Controller controller(options);
    if (const Result<void> started = controller.start(); !started) {
        const Error error = started.error();
        QTextStream(stderr) << "tiller-cli: " << error.context << " (" << error.controllerMessage << ")\n";
        return kFailed;
    }
    const simulator::Ports ports = controller.ports();
    out() << "ready " << options.listenAddress << " dashboard=" << ports.dashboard
          << " primary=" << ports.primary << " secondary=" << ports.secondary
          << " realtime=" << ports.realtime << " rtde=" << ports.rtde << Qt::endl;
    app::waitForTermination();
    controller.stop();
    return kSuccess;
}

int simulate(const QStringList& arguments) {
    QCommandLineParser parser;
    const QCommandLineOption help(QStringList{"h", "help"});
    const QCommandLineOption listen("listen", {}, "ADDRESS", "127.0.0.1");
    const QCommandLineOption offset("port-offset", {}, "N", "0");
    const QCommandLineOption model("model", {}, "MODEL", "ur5e");
    const QCommandLineOption software("software", {}, "VERSION");
    const QCommandLineOption headless("headless");
    const QCommandLineOption programs("programs", {}, "FOLDER");
    const QCommandLineOption priority("priority", {}, "N");
    parser.addOptions({help, listen, offset, model, software, headless, programs, priority});
    if (!parser.parse(arguments)) {
        return wrongArguments(parser.errorText());
    }
    if (parser.isSet(help)) {
        out() << kSimulateHelp;
        return kSuccess;
    }
    if (!parser.positionalArguments().isEmpty()) {
        return wrongArguments(QStringLiteral("'%1' is too much").arg(parser.positionalArguments().first()));
    }

    simulator::ControllerOptions options;
    options.listenAddress = parser.value(listen);
    if (QHostAddress(options.listenAddress).isNull()) {
        return wrongArguments(QStringLiteral("--listen takes an IP address such as 127.0.0.2, not '%1'")
                                  .arg(options.listenAddress));
    }
    bool ok = false;
    options.portOffset = parser.value(offset).toInt(&ok);
    if (!ok || options.portOffset < -29000 || options.portOffset > 35000) {
        return wrongArguments(QStringLiteral("--port-offset takes a number from -29000 to 35000, not '%1'")
                                  .arg(parser.value(offset)));
    }
    const auto id = robotModelByName(parser.value(model));
    if (!id) {
        return wrongArguments(
            QStringLiteral("--model '%1' is not known; there are %2").arg(parser.value(model), modelNames()));
    }
    options.model = *id;
    if (parser.isSet(software)) {
        const auto version = parseSoftware(parser.value(software));
        if (!version) {
            return wrongArguments(QStringLiteral("--software takes a version of series 3 or 5 such as 5.22, "
                                                 "not '%1'")
                                      .arg(parser.value(software)));
        }
        options.software = *version;
    } else if (robotModel(*id).isCb3()) {
        options.software = SoftwareVersion{3, 15, 8, 106339};
    }
    if (options.software.isCb3() != robotModel(*id).isCb3()) {
        return wrongArguments(QStringLiteral("a %1 does not run software %2")
                                  .arg(QString::fromLatin1(robotModel(*id).name), parser.value(software)));
    }
    if (parser.isSet(priority)) {
        options.priority = parser.value(priority).toInt(&ok);
        if (!ok || *options.priority < 1 || *options.priority > 99) {
            return wrongArguments(QStringLiteral("--priority takes a number from 1 to 99, not '%1'")
                                      .arg(parser.value(priority)));
        }
    }
    options.programsFolder = parser.value(programs);
    options.poweredOn = parser.isSet(headless);
    return runController(options);
}

}  // namespace

int main(int argc, char* argv[]) {
    const QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("tiller-cli"));
    QCoreApplication::setApplicationVersion(QStringLiteral(TILLER_VERSION));

    QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() < 2) {
        return wrongArguments(QStringLiteral("a command is missing"));
    }
    const QString command = arguments.at(1);
    if (command == QLatin1String("--help") || command == QLatin1String("-h") ||
        command == QLatin1String("help")) {
        out() << kHelp;
        return kSuccess;
    }
    if (command == QLatin1String("--version") || command == QLatin1String("-v")) {
        out() << "tiller-cli " << TILLER_VERSION << Qt::endl;
        return kSuccess;
    }
    if (command == QLatin1String("simulate")) {
        arguments.removeAt(1);
        return simulate(arguments);
    }
    return wrongArguments(QStringLiteral("'%1' is not a command").arg(command));
}
