// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCommandLineParser>
#include <QJsonDocument>

#include "app/cli_command.h"
#include "robot/doctor/examination.h"

namespace tiller::app {
namespace {

constexpr std::chrono::seconds kAtMost{30};

const QString kHelp = QStringLiteral(
    "tiller-cli doctor: checks whether this PC can control a robot\n"
    "\n"
    "Usage: tiller-cli doctor ADDRESS [options]\n"
    "\n"
    "  ADDRESS              address or host name of the robot\n"
    "  --json               prints one JSON object instead of text\n"
    "  --port-offset N      added to every port number (default 0)\n"
    "  --help               shows this text\n"
    "\n"
    "The command only reads data and does not change anything on the robot or the PC. Exit code: 0 no\n"
    "check failed, 1 a check failed, 2 invalid arguments.\n");

}  // namespace

int doctor(const QStringList& arguments) {
    QCommandLineParser parser;
    const QCommandLineOption help(QStringList{"h", "help"});
    const QCommandLineOption json("json");
    const QCommandLineOption offset("port-offset", {}, "N", "0");
    parser.addOptions({help, json, offset});
    if (!parser.parse(arguments)) {
        return wrongArguments(parser.errorText());
    }
    if (parser.isSet(help)) {
        out() << kHelp;
        return kSuccess;
    }
    if (parser.positionalArguments().size() != 1) {
        return wrongArguments(
            QStringLiteral("doctor: the address of one robot is required, such as 192.168.0.10"));
    }
    bool ok = false;
    const int portOffset = parser.value(offset).toInt(&ok);
    if (!ok || portOffset < -29000 || portOffset > 35000) {
        return wrongArguments(QStringLiteral("--port-offset must be a number from -29000 to 35000, not '%1'")
                                  .arg(parser.value(offset)));
    }
    const tiller::doctor::Report report = tiller::doctor::examine(
        tiller::doctor::patientAt(parser.positionalArguments().constFirst(), portOffset),
        Deadline::after(kAtMost));
    if (parser.isSet(json)) {
        out() << QJsonDocument(tiller::doctor::toJson(report)).toJson();
    } else {
        out() << tiller::doctor::toText(report);
    }
    return tiller::doctor::overall(report) == tiller::doctor::Verdict::Bad ? kFailed : kSuccess;
}

}  // namespace tiller::app
