// SPDX-License-Identifier: GPL-3.0-or-later

#include <QFileInfo>
#include <QHostAddress>
#include <algorithm>

#include "app/cli_command.h"
#include "app/cli_options.h"
#include "app/termination.h"
#include "robot/simulator/faults.h"
#include "robot/simulator/plant/personality.h"
#include "robot/simulator/simulator.h"

namespace tiller::app {

namespace {

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

int simulate(const CommandArguments& arguments) {
    const QStringList faults = arguments.values("fault");
    for (const QString& words : faults) {
        if (words.trimmed() == QLatin1String("help")) {
            out() << QStringLiteral("--fault must be one of\n") << simulator::faultHelp();
            return kSuccess;
        }
    }
    if (arguments.values("assume").contains(QLatin1String("help"))) {
        out() << QStringLiteral(
                     "Behaviour that is not confirmed for real controllers; the first value is the "
                     "default.\n\n")
              << simulator::assumptionHelp();
        return kSuccess;
    }
    if (!arguments.operands().isEmpty()) {
        return wrongArguments(QStringLiteral("unexpected argument '%1'").arg(arguments.operands().first()));
    }

    simulator::SimulatorOptions options;
    options.listenAddress = arguments.value("listen");
    if (QHostAddress(options.listenAddress).isNull()) {
        return wrongArguments(QStringLiteral("--listen must be an IP address such as 127.0.0.2, not '%1'")
                                  .arg(options.listenAddress));
    }
    options.portOffset = static_cast<int>(arguments.number("port-offset"));
    const auto id = robotModelByName(arguments.value("model"));
    if (!id) {
        return wrongArguments(QStringLiteral("--model '%1' is not known; the supported models are %2")
                                  .arg(arguments.value("model"), modelNames()));
    }
    options.model = *id;
    options.software = simulator::defaultSoftware(*id);
    if (arguments.isSet("software")) {
        const auto version = simulator::parseSoftware(arguments.value("software"));
        if (!version) {
            return wrongArguments(QStringLiteral("--software: ") + version.error().context);
        }
        options.software = *version;
    }
    if (const auto fits = simulator::checkSoftware(*id, options.software); !fits) {
        return wrongArguments(fits.error().context);
    }
    if (arguments.isSet("headless") && arguments.isSet("local")) {
        return wrongArguments(QStringLiteral("--headless and --local cannot be combined"));
    }
    for (const QString& words : arguments.values("assume")) {
        if (const auto taken = simulator::assume(options.assumptions, words); !taken) {
            return wrongArguments(QStringLiteral("--assume: ") + taken.error().context);
        }
    }
    options.bootTime = arguments.number("boot-time");
    if (options.bootTime > 0 && arguments.isSet("headless")) {
        return wrongArguments(QStringLiteral("--headless and --boot-time cannot be combined"));
    }
    options.calibration = arguments.number("calibration");
    options.seed = static_cast<std::uint64_t>(arguments.number("seed"));
    if (arguments.isSet("priority")) {
        options.priority = static_cast<int>(arguments.number("priority"));
    }
    options.programsFolder = arguments.value("programs");
    if (arguments.isSet("programs") && !QFileInfo(options.programsFolder).isDir()) {
        return wrongArguments(
            QStringLiteral("--programs: '%1' is not a folder that can be read").arg(options.programsFolder));
    }
    options.urcapsFolder = arguments.value("urcaps");
    for (const QString& words : arguments.values("device")) {
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
    options.poweredOn = arguments.isSet("headless");
    options.remoteControl = !arguments.isSet("local");
    options.gateLocalControl = options.gateLoopbackClients = arguments.isSet("local");
    return runController(options, faults);
}

}  // namespace

const Command& simulateCommand() {
    static const Command kCommand{
        .name = "simulate",
        .summary = "runs a simulated robot controller (see 'tiller-cli simulate --help')",
        .title = "runs a robot controller with a simulated arm on the standard ports",
        .usage = {"[options]"},
        .options =
            {{"listen", "ADDRESS",
              "address to listen on (default %1). Several controllers can run at the same "
              "time on 127.0.0.2, 127.0.0.3... Other machines can connect only if ADDRESS is "
              "a network address of this machine or 0.0.0.0",
              "127.0.0.1"},
             {"port-offset", "N", "added to every port number (default %1)", "0", kPortOffsets},
             {"model", "MODEL", "ur3, ur3e, ur5, ur5e, ur10, ur10e, ur16e, ur20, ur30... (default %1)",
              "ur5e"},
             {"software", "VERSION",
              "version of the controller software: 3.15 for a CB3 model; 5.11, 5.22, 5.25 or "
              "another 5.x; 10.12 for PolyScope X (default: 5.22, for CB3 models 3.15)"},
             {"headless", "", "starts with the brakes released and in remote control, ready to move"},
             {"local", "", "starts in local control and refuses the same commands as a real robot"},
             {"programs", "FOLDER",
              "folder with programs: .urp files as saved by the teach pendant, .urpx files, or URScript "
              "text; also "
              "contains the installation files that the programs use"},
             {"urcaps", "FOLDER",
              "URScript that replaces nodes of URCaps: one .script file for each node class, "
              "with a line '# class: NAME'"},
             {"device", "NAME=FILE",
              "simulates a camera, gripper or other device that replies to programs by XML-RPC or lines of "
              "text, as defined by the table in FILE; can be repeated. The README of robot/simulator "
              "describes the table; the fault 'device' disconnects the device"},
             {"fault", "WORDS",
              "fault that is present from the start; can be repeated. '--fault help' lists all faults. "
              "'tiller-cli fault' triggers the same faults while the simulator is running"},
             {"assume", "NAME=VALUE",
              "sets a behaviour that is not confirmed for real controllers; can be repeated. "
              "'--assume help' lists all names and values"},
             {"boot-time", "SECONDS", "boot time, as on a real controller (default: none)", "0", {0, 3600}},
             {"calibration",
              "SIZE",
              "uses an arm that deviates from its model by up to SIZE mm and mrad (at most 5) and reports "
              "its calibration like a real arm",
              "0",
              {0, 5}},
             {"seed",
              "N",
              "seed of the measurement noise and of all other random values (default %1)",
              "1",
              {0, 1e15}},
             {"priority", "N", "runs at SCHED_FIFO priority N, 1 to 99, if the system permits", "", {1, 99}}},
        .notes =
            "Prints a line that begins with 'ready' when all ports accept connections. Press Ctrl+C or send "
            "SIGTERM to end the command.",
        .run = simulate};
    return kCommand;
}

}  // namespace tiller::app
