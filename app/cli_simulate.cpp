// SPDX-License-Identifier: GPL-3.0-or-later

#include <QCommandLineParser>
#include <QFileInfo>
#include <QHostAddress>
#include <algorithm>

#include "app/cli_command.h"
#include "app/cli_options.h"
#include "app/termination.h"
#include "robot/simulator/box/personality.h"
#include "robot/simulator/faults.h"
#include "robot/simulator/simulator.h"

namespace tiller::app {

namespace {

const QString kSimulateHelp = QStringLiteral(
    "tiller-cli simulate: runs a robot controller with a simulated arm on the standard ports\n"
    "\n"
    "Usage: tiller-cli simulate [options]\n"
    "\n"
    "  --listen ADDRESS     address to listen on (default 127.0.0.1). Several controllers can run at the\n"
    "                       same time on 127.0.0.2, 127.0.0.3... Other machines can connect only if ADDRESS\n"
    "                       is a network address of this machine or 0.0.0.0\n"
    "  --port-offset N      added to every port number (default 0)\n"
    "  --model MODEL        ur3, ur3e, ur5, ur5e, ur10, ur10e, ur16e, ur20, ur30... (default ur5e)\n"
    "  --software VERSION   version of the controller software: 3.15 for a CB3 model; 5.11, 5.22, 5.25 or\n"
    "                       another 5.x; 10.12 for PolyScope X (default: 5.22, for CB3 models 3.15)\n"
    "  --headless           starts with the brakes released and in remote control, ready to move\n"
    "  --local              starts in local control and refuses the same commands as a real robot\n"
    "  --programs FOLDER    folder with programs: .urp files as saved by the pendant, .urpx, or URScript\n"
    "                       text; with the installation files that they name\n"
    "  --urcaps FOLDER      URScript that replaces nodes of URCaps: one .script file for each node class,\n"
    "                       with a line '# class: NAME'\n"
    "  --device NAME=FILE   simulates a camera, gripper or other device that replies to programs by XML-RPC\n"
    "                       or lines of text, as defined by the table in FILE; can be repeated. The README\n"
    "                       of robot/simulator describes the table; the fault 'device' disconnects it\n"
    "  --fault WORDS        fault that is present from the start; can be repeated. See\n"
    "                       'tiller-cli fault --help': the same words work while the simulator runs;\n"
    "                       '--fault help' lists them\n"
    "  --assume NAME=VALUE  sets a behaviour that is not confirmed for real controllers; can be repeated.\n"
    "                       '--assume help' lists all names and values\n"
    "  --boot-time SECONDS  duration of booting, as on a real controller (default: none)\n"
    "  --calibration SIZE   uses an arm that deviates from its model by up to SIZE mm and mrad (at most 5)\n"
    "                       and reports its calibration as real arms do\n"
    "  --seed N             seed of the measurement noise and of all other random values (default 1)\n"
    "  --priority N         runs at SCHED_FIFO priority N, 1 to 99, if the system permits\n"
    "  --help               shows this text\n"
    "\n"
    "Prints a line beginning with 'ready' when all ports accept connections. Ends on Ctrl-C or SIGTERM.\n");

QString modelNames() {
    QStringList names;
    for (const RobotModel& model : robotModels()) {
        names << QString::fromLatin1(model.name).toLower();
    }
    return names.join(QStringLiteral(", "));
}

QString readyLine(const simulator::Simulator& controller) {
    const simulator::Ports ports = controller.ports();
    const std::pair<const char*, std::uint16_t> named[] = {
        {"dashboard", ports.dashboard},
        {"primary", ports.primary},
        {"secondary", ports.secondary},
        {"realtime", ports.realtime},
        {"rtde", ports.rtde},
        {"primary-read-only", ports.primaryReadOnly},
        {"secondary-read-only", ports.secondaryReadOnly},
        {"realtime-read-only", ports.realtimeReadOnly},
        {"interpreter", ports.interpreter},
        {"robot-api", ports.robotApi},
        {"gripper", ports.gripper},
        {"faults", ports.faults},
    };
    QString line = QStringLiteral("ready ") + controller.listenAddress();
    for (const auto& [name, port] : named) {
        if (port != 0) {
            line += QStringLiteral(" %1=%2").arg(QLatin1String(name)).arg(port);
        }
    }
    return line;
}

int runController(const simulator::SimulatorOptions& options, const QStringList& faults) {
    holdTerminationSignals();
    simulator::Simulator controller(options);
    if (const Result<void> started = controller.start(); !started) {
        const Error error = started.error();
        const QString words = error.controllerMessage.isEmpty()
                                  ? QString()
                                  : QStringLiteral(" (%1)").arg(error.controllerMessage);
        return complain(error.context + words, kFailed);
    }
    for (const QString& words : faults) {
        if (const Result<QString> done = controller.inject(words); !done) {
            return complain(QStringLiteral("--fault ") + done.error().context, kWrongArguments);
        }
    }
    out() << readyLine(controller) << Qt::endl;
    waitForTermination();
    controller.stop();
    return kSuccess;
}

}  // namespace

int simulate(const QStringList& arguments) {
    QCommandLineParser parser;
    const QCommandLineOption help(QStringList{"h", "help"});
    const QCommandLineOption listen("listen", {}, "ADDRESS", "127.0.0.1");
    const QCommandLineOption offset("port-offset", {}, "N", "0");
    const QCommandLineOption model("model", {}, "MODEL", "ur5e");
    const QCommandLineOption software("software", {}, "VERSION");
    const QCommandLineOption headless("headless");
    const QCommandLineOption local("local");
    const QCommandLineOption programs("programs", {}, "FOLDER");
    const QCommandLineOption urcaps("urcaps", {}, "FOLDER");
    const QCommandLineOption device("device", {}, "NAME=FILE");
    const QCommandLineOption fault("fault", {}, "WORDS");
    const QCommandLineOption assumed("assume", {}, "NAME=VALUE");
    const QCommandLineOption bootTime("boot-time", {}, "SECONDS", "0");
    const QCommandLineOption calibration("calibration", {}, "SIZE", "0");
    const QCommandLineOption seed("seed", {}, "N", "1");
    const QCommandLineOption priority("priority", {}, "N");
    parser.addOptions({help, listen, offset, model, software, headless, local, programs, urcaps, device,
                       fault, assumed, bootTime, calibration, seed, priority});
    if (!parser.parse(arguments)) {
        return wrongArguments(parser.errorText());
    }
    if (parser.isSet(help)) {
        out() << kSimulateHelp;
        return kSuccess;
    }
    const QStringList faults = parser.values(fault);
    for (const QString& words : faults) {
        if (words.trimmed() == QLatin1String("help")) {
            out() << QStringLiteral("--fault must be one of\n") << simulator::faultHelp();
            return kSuccess;
        }
    }
    if (parser.values(assumed).contains(QLatin1String("help"))) {
        out() << QStringLiteral("Unknown properties of real controllers; the first value is the default.\n\n")
              << simulator::assumptionHelp();
        return kSuccess;
    }
    if (!parser.positionalArguments().isEmpty()) {
        return wrongArguments(
            QStringLiteral("unexpected argument '%1'").arg(parser.positionalArguments().first()));
    }

    simulator::SimulatorOptions options;
    options.listenAddress = parser.value(listen);
    if (QHostAddress(options.listenAddress).isNull()) {
        return wrongArguments(QStringLiteral("--listen must be an IP address such as 127.0.0.2, not '%1'")
                                  .arg(options.listenAddress));
    }
    bool ok = false;
    options.portOffset = parser.value(offset).toInt(&ok);
    if (!ok || options.portOffset < -29000 || options.portOffset > 35000) {
        return wrongArguments(QStringLiteral("--port-offset must be a number from -29000 to 35000, not '%1'")
                                  .arg(parser.value(offset)));
    }
    const auto id = robotModelByName(parser.value(model));
    if (!id) {
        return wrongArguments(QStringLiteral("--model '%1' is not known; the models are %2")
                                  .arg(parser.value(model), modelNames()));
    }
    options.model = *id;
    options.software = simulator::defaultSoftware(*id);
    if (parser.isSet(software)) {
        const auto version = simulator::parseSoftware(parser.value(software));
        if (!version) {
            return wrongArguments(QStringLiteral("--software: ") + version.error().context);
        }
        options.software = *version;
    }
    if (const auto fits = simulator::checkSoftware(*id, options.software); !fits) {
        return wrongArguments(fits.error().context);
    }
    if (parser.isSet(headless) && parser.isSet(local)) {
        return wrongArguments(QStringLiteral("--headless and --local cannot be combined"));
    }
    for (const QString& words : parser.values(assumed)) {
        if (const auto taken = simulator::assume(options.assumptions, words); !taken) {
            return wrongArguments(QStringLiteral("--assume: ") + taken.error().context);
        }
    }
    const auto boot = numberIn(parser, bootTime, 0, 3600);
    const auto deviation = numberIn(parser, calibration, 0, 5);
    const auto number = numberIn(parser, seed, 0, 1e15);
    const auto wished = parser.isSet(priority) ? numberIn(parser, priority, 1, 99) : std::optional<double>(0);
    if (!boot || !deviation || !number || !wished) {
        return kWrongArguments;
    }
    if (*boot > 0 && parser.isSet(headless)) {
        return wrongArguments(QStringLiteral("--headless and --boot-time cannot be combined"));
    }
    options.bootTime = *boot;
    options.calibration = *deviation;
    options.seed = static_cast<std::uint64_t>(*number);
    if (*wished > 0) {
        options.priority = static_cast<int>(*wished);
    }
    options.programsFolder = parser.value(programs);
    if (parser.isSet(programs) && !QFileInfo(options.programsFolder).isDir()) {
        return wrongArguments(
            QStringLiteral("--programs: '%1' is not a folder that can be read").arg(options.programsFolder));
    }
    options.urcapsFolder = parser.value(urcaps);
    for (const QString& words : parser.values(device)) {
        const QString name = words.section('=', 0, 0).trimmed(), file = words.section('=', 1).trimmed();
        const bool isTaken = std::any_of(options.devices.begin(), options.devices.end(),
                                         [&name](const auto& other) { return other.name == name; });
        if (name.isEmpty() || name.contains(' ') || file.isEmpty() || isTaken) {
            return wrongArguments(
                QStringLiteral(
                    "--device must be a unique name and a file, such as camera=camera.txt, not '%1'")
                    .arg(words));
        }
        options.devices.push_back({name, file});
    }
    options.poweredOn = parser.isSet(headless);
    options.remoteControl = !parser.isSet(local);
    options.gateLocalControl = options.gateLoopbackClients = parser.isSet(local);
    return runController(options, faults);
}

}  // namespace tiller::app
