// SPDX-License-Identifier: GPL-3.0-or-later
#include <QJsonDocument>

#include "app/cli_command.h"
#include "app/cli_options.h"
#include "robot/doctor/examination.h"

namespace tiller::app {
namespace {

constexpr std::chrono::seconds kAtMost{30};

int examine(const CommandArguments& arguments) {
    if (arguments.operands().size() != 1) {
        return wrongArguments(
            QStringLiteral("doctor: the address of one robot is required, such as 192.168.0.10"));
    }
    const auto portOffset = static_cast<int>(arguments.number("port-offset"));
    const tiller::doctor::Report report = tiller::doctor::examine(
        tiller::doctor::patientAt(arguments.operands().constFirst(), portOffset), Deadline::after(kAtMost));
    if (arguments.isSet("json")) {
        out() << QJsonDocument(tiller::doctor::toJson(report)).toJson();
    } else {
        out() << tiller::doctor::toText(report);
    }
    return tiller::doctor::overall(report) == tiller::doctor::Verdict::Bad ? kFailed : kSuccess;
}

}  // namespace

const Command& doctorCommand() {
    static const Command kCommand{
        .name = "doctor",
        .operands = "ADDRESS",
        .summary = "checks whether this PC can control a robot",
        .title = "checks whether this PC can control a robot",
        .usage = {"ADDRESS [options]"},
        .operandRows = {{"ADDRESS", "address or host name of the robot"}},
        .options = {{"json", "", "prints one JSON object instead of text"},
                    {"port-offset", "N", "added to every port number (default %1)", "0", kPortOffsets}},
        .notes =
            "The command only reads data and does not change anything on the robot or the "
            "PC. Exit code: 0 no check failed, 1 a check failed, 2 invalid arguments.",
        .run = examine};
    return kCommand;
}

}  // namespace tiller::app
