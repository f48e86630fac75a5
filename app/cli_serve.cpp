// SPDX-License-Identifier: GPL-3.0-or-later

#include <QCommandLineParser>
#include <QTextStream>
#include <algorithm>

#include "app/cli_command.h"
#include "app/cli_options.h"
#include "app/cli_progress.h"
#include "app/termination.h"
#include "robot/live/live_output.h"

namespace tiller::app {

namespace {

constexpr std::chrono::milliseconds kShowEvery{100};

const QString kServeHelp = QStringLiteral(
    "tiller-cli serve: forwards live data of a robot to viewers\n"
    "\n"
    "Usage: tiller-cli serve ADDRESS [options]\n"
    "\n"
    "  ADDRESS              address or host name of the robot, or of a simulated robot\n"
    "  --listen ADDRESS     address that Foxglove and other viewers connect to (default 127.0.0.1: only\n"
    "                       this machine; 0.0.0.0: every machine on the network). The server is read-only:\n"
    "                       no viewer can move the robot\n"
    "  --port N             port of the server (default 8765); 0: a free port\n"
    "  --allow-origin ORIGIN  web page or app that may connect, such as https://app.foxglove.dev (Foxglove\n"
    "                       in a browser) or file:// (desktop apps: Foxglove, Lichtblick). Can be repeated\n"
    "  --no-server          starts no server; requires --udp\n"
    "  --udp ADDRESS[:PORT] sends JSON in UDP datagrams, one for each package, to PlotJuggler (port 9870)\n"
    "  --fields A,B,...     RTDE outputs to forward; default: all that the window shows\n"
    "  --wait SECONDS       time to wait for the first package (default 10)\n"
    "  --quiet              shows no progress on the terminal\n"
    "  --port-offset N      added to every port number of the robot (default 0)\n"
    "  --help               shows this text\n"
    "\n"
    "Limits of the server: 16 viewers with a subscription; 32 connections without a subscription and 32\n"
    "handshakes (a new one replaces the oldest); handshake within 5 s and 16 KiB; requests of at most\n"
    "64 KiB each and 1 MiB/s; 8 MiB of unsent messages for each viewer (the oldest are dropped). A viewer\n"
    "that reads nothing for 10 s, or does not read the responses to its requests, is disconnected. Web\n"
    "pages are refused unless they come from this machine or from an allowed origin.\n"
    "\n"
    "Prints a line beginning with 'ready'. Ends on Ctrl-C or SIGTERM. Reconnects when the connection to\n"
    "the robot is lost. Exit code: 0 ended by Ctrl-C or SIGTERM, 1 no data or port not available, 2 invalid\n"
    "arguments.\n");

/// Prints each rejected origin only once, so that many rejected requests do not fill the terminal.
class RefusedOrigins {
public:
    void show(const QString& origin) {
        constexpr qsizetype kMaxShown = 20;
        if (!origin.isEmpty() && shown_.size() < kMaxShown && !shown_.contains(origin)) {
            shown_ << origin;
            QTextStream(stderr)
                << QStringLiteral("\nserve: refused a viewer with the origin %1; --allow-origin permits it")
                       .arg(printable(origin))
                << Qt::endl;
        }
    }

private:
    /// Removes control characters, because the peer determines the origin text.
    static QString printable(QString text) {
        std::replace_if(
            text.begin(), text.end(), [](QChar c) { return !c.isPrint(); }, QChar(u'?'));
        return text;
    }
    QStringList shown_;
};

}  // namespace

int serve(const QStringList& arguments) {
    QCommandLineParser parser;
    const QCommandLineOption help(QStringList{"h", "help"});
    const QCommandLineOption listen("listen", {}, "ADDRESS", "127.0.0.1");
    const QCommandLineOption port("port", {}, "N", "8765");
    const QCommandLineOption allowOrigin("allow-origin", {}, "ORIGIN");
    const QCommandLineOption noServer("no-server");
    const QCommandLineOption udp("udp", {}, "ADDRESS");
    const QCommandLineOption fields("fields", {}, "A,B");
    const QCommandLineOption wait("wait", {}, "SECONDS", "10");
    const QCommandLineOption quiet("quiet");
    const QCommandLineOption offset("port-offset", {}, "N", "0");
    parser.addOptions({help, listen, port, allowOrigin, noServer, udp, fields, wait, quiet, offset});
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
            QStringLiteral("serve: the address of one robot is required, such as 192.168.0.10"));
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
    const QStringList origins = parser.values(allowOrigin);
    options.allowedOrigins.assign(origins.begin(), origins.end());
    options.fields = namesIn(parser.value(fields));
    if (parser.isSet(udp)) {
        const QStringList parts = parser.value(udp).split(':');
        bool ok = parts.size() <= 2;
        options.udpAddress = parts.constFirst();
        options.udpPort = parts.size() < 2 ? options.udpPort : parts[1].toUShort(&ok);
        if (!ok || options.udpPort == 0) {
            return wrongArguments(QStringLiteral("--udp: '%1' must be an address, optionally with a port")
                                      .arg(parser.value(udp)));
        }
    } else if (options.listenAddress.isEmpty()) {
        return wrongArguments(QStringLiteral("serve: --no-server requires --udp"));
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
    if (auto came = receiver.waitForData(Deadline::after(std::chrono::duration<double>(*patience)),
                                         receive::OnRefusal::Wait);
        !came) {
        return complain(QStringLiteral("no data from %1: %2").arg(wanted.host, came.error().toString()),
                        kFailed);
    }
    live::LiveOutput output;
    if (const auto started = output.start(options, receiver); !started) {
        return complain(started.error().toString(),
                        started.error().code == ErrorCode::AddressInvalid ? kWrongArguments : kFailed);
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
    RefusedOrigins refused;
    while (!waitForTermination(kShowEvery)) {
        const live::LiveProgress progress = output.progress();
        refused.show(progress.refusedOrigin);
        line.show(
            QStringLiteral("%1 viewers  %2 packages  %3 messages  %4 dropped  %5 datagrams  %6 disconnected  "
                           "%7 refused")
                .arg(progress.viewers)
                .arg(progress.packets)
                .arg(progress.messages)
                .arg(progress.dropped)
                .arg(progress.datagrams)
                .arg(progress.disconnected)
                .arg(progress.refused));
    }
    output.stop();
    return kSuccess;
}

}  // namespace tiller::app
