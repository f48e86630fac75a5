// SPDX-License-Identifier: GPL-3.0-or-later

#include <QCommandLineParser>

#include "app/cli_command.h"
#include "app/cli_options.h"
#include "app/cli_progress.h"
#include "app/termination.h"
#include "robot/live/live_output.h"

namespace tiller::app {

namespace {

constexpr std::chrono::milliseconds kShowEvery{100};

const QString kServeHelp = QStringLiteral(
    "tiller-cli serve: sends on what a robot sends, while it comes\n"
    "\n"
    "Usage: tiller-cli serve ADDRESS [options]\n"
    "\n"
    "  ADDRESS              address or host name of the robot, or of a simulated one\n"
    "  --listen ADDRESS     where Foxglove and other viewers connect (default 127.0.0.1: this machine only;\n"
    "                       0.0.0.0: every one that reaches it). It only tells: no viewer can move the "
    "robot\n"
    "  --port N             the port of that server (default 8765); 0: one that is free\n"
    "  --no-server          no server\n"
    "  --udp ADDRESS[:PORT] JSON in UDP datagrams, one a package, to PlotJuggler (its port: 9870)\n"
    "  --fields A,B,...     RTDE outputs to send on; without it all that the window shows\n"
    "  --wait SECONDS       for the first package (default 10)\n"
    "  --quiet              no progress on the terminal\n"
    "  --port-offset N      added to the robot's port numbers (default 0)\n"
    "  --help               this text\n"
    "\n"
    "Prints one line beginning with 'ready'. Ends on Ctrl-C or SIGTERM. When the link to the robot breaks, "
    "it\n"
    "comes back by itself. Exit code: 0, 1 no data or no port, 2 wrong arguments.\n");

}  // namespace

int serve(const QStringList& arguments) {
    QCommandLineParser parser;
    const QCommandLineOption help(QStringList{"h", "help"});
    const QCommandLineOption listen("listen", {}, "ADDRESS", "127.0.0.1");
    const QCommandLineOption port("port", {}, "N", "8765");
    const QCommandLineOption noServer("no-server");
    const QCommandLineOption udp("udp", {}, "ADDRESS");
    const QCommandLineOption fields("fields", {}, "A,B");
    const QCommandLineOption wait("wait", {}, "SECONDS", "10");
    const QCommandLineOption quiet("quiet");
    const QCommandLineOption offset("port-offset", {}, "N", "0");
    parser.addOptions({help, listen, port, noServer, udp, fields, wait, quiet, offset});
    if (!parser.parse(arguments)) {
        return wrongArguments(parser.errorText());
    }
    if (parser.isSet(help)) {
        out() << kServeHelp;
        out().flush();
        return kSuccess;
    }
    if (parser.positionalArguments().size() != 1) {
        return wrongArguments(
            QStringLiteral("serve: the address of one robot is needed, as in 192.168.0.10"));
    }
    const auto serverPort = numberIn(parser, port, 0, 65535);
    const auto patience = numberIn(parser, wait, 0, 1e6);
    const auto portOffset = numberIn(parser, offset, -29000, 35000);
    if (!serverPort || !patience || !portOffset) {
        return kWrongArguments;
    }
    live::LiveOptions options;
    options.listenAddress = parser.isSet(noServer) ? QString() : parser.value(listen);
    options.port = static_cast<std::uint16_t>(*serverPort);
    options.fields = namesIn(parser.value(fields));
    if (parser.isSet(udp)) {
        const QStringList parts = parser.value(udp).split(':');
        bool ok = parts.size() <= 2;
        options.udpAddress = parts.constFirst();
        options.udpPort = parts.size() < 2 ? options.udpPort : parts[1].toUShort(&ok);
        if (!ok || options.udpPort == 0) {
            return wrongArguments(QStringLiteral("--udp: '%1' is not an address, or an address and a port")
                                      .arg(parser.value(udp)));
        }
    } else if (options.listenAddress.isEmpty()) {
        return wrongArguments(
            QStringLiteral("serve: with --no-server and without --udp there is nothing to do"));
    }
    holdTerminationSignals();
    receive::ReceiverOptions wanted;
    wanted.host = parser.positionalArguments().constFirst();
    wanted.port = static_cast<std::uint16_t>(rtde::kPort + static_cast<int>(*portOffset));
    if (!options.fields.empty()) {
        wanted.fields = options.fields;
    }
    receive::Receiver receiver(wanted);
    if (const auto started = receiver.start(); !started) {
        return complain(started.error().controllerMessage, kWrongArguments);
    }
    if (auto came = receiver.waitForData(Deadline::after(std::chrono::duration<double>(*patience))); !came) {
        return complain(QStringLiteral("no data from %1: %2").arg(wanted.host, came.error().toString()),
                        kFailed);
    }
    live::LiveOutput output;
    if (const auto started = output.start(options, receiver); !started) {
        return complain(started.error().toString(), kFailed);
    }
    out() << "ready";
    if (output.port() != 0) {
        out() << QStringLiteral(" ws://%1:%2").arg(options.listenAddress).arg(output.port());
    }
    if (!options.udpAddress.isEmpty()) {
        out() << QStringLiteral(" udp://%1:%2").arg(options.udpAddress).arg(options.udpPort);
    }
    out() << Qt::endl;
    ProgressLine line(!parser.isSet(quiet));
    while (!waitForTermination(kShowEvery)) {
        const live::LiveProgress progress = output.progress();
        line.show(QStringLiteral("%1 viewers  %2 packages  %3 messages  %4 left out  %5 datagrams")
                      .arg(progress.viewers)
                      .arg(progress.packets)
                      .arg(progress.messages)
                      .arg(progress.dropped)
                      .arg(progress.datagrams));
    }
    output.stop();
    return kSuccess;
}

}  // namespace tiller::app
