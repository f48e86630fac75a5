// SPDX-License-Identifier: GPL-3.0-or-later

#include <QTextStream>
#include <algorithm>
#include <utility>

#include "app/cli_command.h"
#include "app/cli_options.h"
#include "app/cli_progress.h"
#include "app/termination.h"
#include "robot/live/live_output.h"

namespace tiller::app {

namespace {

constexpr std::chrono::milliseconds kShowEvery{100};

/// Prints each refused origin only once, so that repeated requests do not flood the terminal.
class RefusedOrigins {
public:
    void show(const QString& origin) {
        constexpr qsizetype kMaxShown = 20;
        if (!origin.isEmpty() && shown_.size() < kMaxShown && !shown_.contains(origin)) {
            shown_ << origin;
            QTextStream(stderr) << QStringLiteral(
                                       "\nserve: refused a viewer with the origin %1; use --allow-origin to "
                                       "allow this origin")
                                       .arg(printable(origin))
                                << Qt::endl;
        }
    }

private:
    /// Removes control characters, because the text comes from the peer.
    static QString printable(QString text) {
        std::replace_if(
            text.begin(), text.end(), [](QChar c) { return !c.isPrint(); }, QChar(u'?'));
        return text;
    }
    QStringList shown_;
};

int serve(const CommandArguments& arguments) {
    if (arguments.operands().size() != 1) {
        return wrongArguments(
            QStringLiteral("serve: the address of one robot is required, such as 192.168.0.10"));
    }
    live::LiveOptions options;
    options.listenAddress = arguments.isSet("no-server") ? QString() : arguments.value("listen");
    options.port = static_cast<std::uint16_t>(arguments.number("port"));
    const QStringList origins = arguments.values("allow-origin");
    options.allowedOrigins.assign(origins.begin(), origins.end());
    options.fields = namesIn(arguments.value("fields"));
    if (arguments.isSet("udp")) {
        const QStringList parts = arguments.value("udp").split(':');
        bool ok = parts.size() <= 2;
        options.udpAddress = parts.constFirst();
        options.udpPort = parts.size() < 2 ? options.udpPort : parts[1].toUShort(&ok);
        if (!ok || options.udpPort == 0) {
            return wrongArguments(QStringLiteral("--udp: '%1' must be an address, optionally with a port")
                                      .arg(arguments.value("udp")));
        }
    } else if (options.listenAddress.isEmpty()) {
        return wrongArguments(QStringLiteral("serve: --no-server requires --udp"));
    }
    holdTerminationSignals();
    receive::ReceiverOptions wanted;
    wanted.host = arguments.operands().constFirst();
    wanted.port = static_cast<std::uint16_t>(rtde::kPort + static_cast<int>(arguments.number("port-offset")));
    if (!options.fields.empty()) {
        wanted.fields = options.fields;
    }
    receive::Receiver receiver(wanted);
    if (const auto started = receiver.start(); !started) {
        return complain(started.error().controllerMessage, kWrongArguments);
    }
    if (auto came =
            receiver.waitForData(Deadline::after(std::chrono::duration<double>(arguments.number("wait"))),
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
    ProgressLine line(!arguments.isSet("quiet"));
    RefusedOrigins refused;
    bool hasMissed = false;
    while (!waitForTermination(kShowEvery)) {
        const live::LiveProgress progress = output.progress();
        refused.show(progress.refusedOrigin);
        if (progress.missed > 0 && !std::exchange(hasMissed, true)) {
            QTextStream(stderr) << "\nserve: packets were not sent because this machine is too busy"
                                << Qt::endl;
        }
        line.show(
            QStringLiteral(
                "%1 viewers  %2 packets  %3 messages  %4 dropped  %5 datagrams  %6 disconnected  %7 refused")
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

}  // namespace

const Command& serveCommand() {
    static const Command kCommand{
        .name = "serve",
        .operands = "ADDRESS",
        .summary = "forwards live data from a robot to Foxglove or PlotJuggler",
        .title = "forwards live data from a robot to viewers",
        .usage = {"ADDRESS [options]"},
        .operandRows = {{"ADDRESS", "address or host name of the robot, or of a simulated robot"}},
        .options = {{"listen", "ADDRESS",
                     "address that Foxglove and other viewers connect to (default %1: only this "
                     "machine; 0.0.0.0: every machine on the network). The server is read-only: no "
                     "viewer can move the robot",
                     "127.0.0.1"},
                    {"port", "N", "port of the server (default %1); 0: a free port", "8765", {0, 65535}},
                    {"allow-origin", "ORIGIN",
                     "web page or app that may connect, such as https://app.foxglove.dev (Foxglove "
                     "in a browser) or file:// (desktop apps: Foxglove, Lichtblick). Can be repeated"},
                    {"no-server", "", "starts no server; requires --udp"},
                    {"udp", "ADDRESS[:PORT]",
                     "sends one UDP datagram with JSON for each packet to PlotJuggler (default port 9870)"},
                    {"fields", "A,B,...",
                     "RTDE outputs to forward; default: all fields that the window shows"},
                    {"wait", "SECONDS", "time to wait for the first packet (default %1)", "10", {0, 1e6}},
                    {"quiet", "", "shows no progress on the terminal"},
                    {"port-offset", "N", "added to every port number of the robot (default %1)", "0",
                     kPortOffsets}},
        .notes =
            "Server limits: 16 viewers with a subscription; 32 connections without a subscription and 32 "
            "handshakes (a new connection replaces the oldest); handshake within 5 s and 16 KiB; requests of "
            "at most 64 KiB each and 1 MiB/s; 8 MiB of unsent messages for each viewer (the oldest are "
            "dropped). A viewer that reads nothing for 10 s, or does not read the responses to its requests, "
            "is disconnected. Web pages are refused unless they come from this machine or from an allowed "
            "origin.\n\nPrints a line that begins with 'ready'. Press Ctrl+C or send SIGTERM to end the "
            "command. Reconnects when the connection to the robot is lost. Exit code: 0 ended by Ctrl+C or "
            "SIGTERM, 1 no data or port not available, 2 invalid arguments.",
        .run = serve};
    return kCommand;
}

}  // namespace tiller::app
