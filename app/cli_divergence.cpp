// SPDX-License-Identifier: GPL-3.0-or-later

#include <QCommandLineParser>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <numbers>

#include "app/cli_command.h"
#include "app/cli_options.h"
#include "app/cli_progress.h"
#include "robot/divergence/divergence.h"
#include "robot/recording/formats/open_recording.h"

namespace tiller::app {

namespace {

using divergence::Quantity;

const QString kDivergenceHelp = QStringLiteral(
    "tiller-cli divergence: compares the motion of an arm with its model\n"
    "\n"
    "Usage: tiller-cli divergence FILE [options]\n"
    "\n"
    "  FILE                 recording (.mcap, .h5 or .csv), such as that of an incident. The arm of the\n"
    "                       simulated controller follows the targets of the recording, and its motion is\n"
    "                       compared with that of the real arm. The simulated arm carries the payload that\n"
    "                       is set on the controller, and has neither contact nor friction\n"
    "  --model MODEL        robot model, such as ur5e (default: the model named in the recording)\n"
    "  --joint DEGREES      largest permitted deviation of each joint (default 0.5); 0: not compared\n"
    "  --tcp MM             the same for the TCP (default 5)\n"
    "  --current A          the same for the current of each joint (default 2)\n"
    "  --force N            the same for the force at the TCP (default 30)\n"
    "  --lasting SECONDS    ignores shorter deviations (default 0.01)\n"
    "  --from, --until SECONDS   compares only this part\n"
    "  --json               prints one JSON object instead of text\n"
    "  --quiet              shows no progress on the terminal\n"
    "  --help               shows this text\n"
    "\n"
    "Exit code: 0 arm and model agree, 1 they differ or cannot be compared, 2 invalid arguments.\n");

/// Output format of a quantity: its name, its unit, and the conversion factor from SI.
struct Spelling {
    const char* key;
    const char* name;
    const char* unit;
    double factor;
    int digits;
};

const Spelling& spellingOf(Quantity quantity) {
    static const Spelling kSpellings[divergence::kQuantityCount] = {
        {"joint", "joint position", "deg", 180 / std::numbers::pi, 3},
        {"tcp", "TCP position", "mm", 1e3, 2},
        {"current", "joint current", "A", 1, 3},
        {"force", "TCP force", "N", 1, 1}};
    return kSpellings[static_cast<std::size_t>(quantity)];
}

QString placeOf(const divergence::Difference& difference) {
    return difference.joint < 0
               ? QStringLiteral("TCP")
               : QString::fromLatin1(kJointNames[static_cast<std::size_t>(difference.joint)]);
}

QString amountOf(const divergence::Difference& difference) {
    const Spelling& spelling = spellingOf(difference.quantity);
    return QStringLiteral("%1 %2")
        .arg(difference.amount * spelling.factor, 0, 'f', spelling.digits)
        .arg(QLatin1String(spelling.unit));
}

QStringList namesOf(const std::vector<std::string>& fields) {
    QStringList names;
    for (const std::string& field : fields) {
        names << QString::fromStdString(field);
    }
    return names;
}

QJsonObject toJson(const divergence::Difference& difference) {
    const Spelling& spelling = spellingOf(difference.quantity);
    return {{"quantity", spelling.key},
            {"joint", difference.joint},
            {"row", static_cast<double>(difference.row)},
            {"seconds", difference.seconds},
            {"amount", difference.amount * spelling.factor},
            {"unit", spelling.unit}};
}

QJsonObject toJson(const divergence::Report& report) {
    QJsonArray outcomes;
    for (const divergence::Outcome& outcome : report.outcomes) {
        const Spelling& spelling = spellingOf(outcome.quantity);
        QJsonObject one{{"quantity", spelling.key},
                        {"limit", outcome.limit * spelling.factor},
                        {"unit", spelling.unit},
                        {"rows", static_cast<double>(outcome.rows)},
                        {"missing", QJsonArray::fromStringList(namesOf(outcome.missing))}};
        if (outcome.greatest) {
            one["greatest"] = toJson(*outcome.greatest);
        }
        if (outcome.parted) {
            one["parted"] = toJson(*outcome.parted);
        }
        outcomes.append(one);
    }
    QJsonObject all{{"model", robotModel(report.model).name},
                    {"gravity", QJsonArray{report.gravity.x(), report.gravity.y(), report.gravity.z()}},
                    {"rows", static_cast<double>(report.rows)},
                    {"left_out", static_cast<double>(report.leftOut)},
                    {"from_start", report.partedFromStart()},
                    {"outcomes", outcomes}};
    if (const auto first = report.first()) {
        all["first"] = toJson(*first);
    }
    return all;
}

void print(const divergence::Report& report) {
    out() << QStringLiteral(
                 "%1 rows compared with the model of a %2, %3 skipped (no power, guided by hand, or after a "
                 "gap)\n")
                 .arg(report.rows - report.leftOut)
                 .arg(QLatin1String(robotModel(report.model).name))
                 .arg(report.leftOut);
    for (const divergence::Outcome& outcome : report.outcomes) {
        const Spelling& spelling = spellingOf(outcome.quantity);
        const QString limit = QStringLiteral("%1 (limit %2 %3)")
                                  .arg(QLatin1String(spelling.name))
                                  .arg(outcome.limit * spelling.factor, 0, 'g', 4)
                                  .arg(QLatin1String(spelling.unit));
        if (!(outcome.limit > 0)) {
            out() << "  " << spelling.name << ": not compared\n";
        } else if (!outcome.missing.empty()) {
            out() << "  " << spelling.name << ": not compared, the recording has no "
                  << namesOf(outcome.missing).join(QStringLiteral(", ")) << "; record all fields\n";
        } else if (!outcome.greatest) {
            out() << "  " << limit << ": no values\n";
        } else {
            out() << "  " << limit
                  << QStringLiteral(": at most %1, %2 at %3 s\n")
                         .arg(amountOf(*outcome.greatest), placeOf(*outcome.greatest))
                         .arg(outcome.greatest->seconds, 0, 'f', 3);
        }
        if (outcome.parted) {
            out() << QStringLiteral("    above the limit from %1 s (row %2): %3, up to %4\n")
                         .arg(outcome.parted->seconds, 0, 'f', 3)
                         .arg(outcome.parted->row)
                         .arg(placeOf(*outcome.parted), amountOf(*outcome.parted));
        }
    }
    const auto first = report.first();
    if (!first) {
        out() << (report.firstCompared ? "arm and model agree\n" : "nothing could be compared\n");
        return;
    }
    out() << QStringLiteral("arm and model differ from %1 s: %2, %3 of %4\n")
                 .arg(first->seconds, 0, 'f', 3)
                 .arg(placeOf(*first), amountOf(*first), QLatin1String(spellingOf(first->quantity).name));
    if (report.partedFromStart()) {
        out() << "Arm and model differ from the first sample on: check --model and the payload set on the "
                 "robot, and that nothing touches the arm.\n";
    }
}

/// Reads the value of an optional command line option.
bool readLimit(const QCommandLineParser& parser, const QCommandLineOption& option, double factor,
               double& limit) {
    constexpr double kMaxValue = 1e6;
    if (!parser.isSet(option)) {
        return true;
    }
    const auto value = numberIn(parser, option, 0, kMaxValue);
    limit = value ? *value * factor : limit;
    return value.has_value();
}

}  // namespace

int divergence(const QStringList& arguments) {
    QCommandLineParser parser;
    const QCommandLineOption help(QStringList{"h", "help"});
    const QCommandLineOption model("model", {}, "MODEL");
    const QCommandLineOption joint("joint", {}, "DEGREES");
    const QCommandLineOption tcp("tcp", {}, "MM");
    const QCommandLineOption current("current", {}, "A");
    const QCommandLineOption force("force", {}, "N");
    const QCommandLineOption lasting("lasting", {}, "SECONDS");
    const QCommandLineOption from("from", {}, "SECONDS");
    const QCommandLineOption until("until", {}, "SECONDS");
    const QCommandLineOption json("json");
    const QCommandLineOption quiet("quiet");
    parser.addOptions({help, model, joint, tcp, current, force, lasting, from, until, json, quiet});
    if (!parser.parse(arguments)) {
        return wrongArguments(parser.errorText());
    }
    if (parser.isSet(help)) {
        out() << kDivergenceHelp;
        out().flush();
        return kSuccess;
    }
    if (parser.positionalArguments().size() != 1) {
        return wrongArguments(QStringLiteral("divergence: exactly one recording is required"));
    }
    divergence::Choice choice;
    if (parser.isSet(model)) {
        choice.model = robotModelByName(parser.value(model));
        if (!choice.model) {
            QStringList known;
            for (const RobotModel& each : robotModels()) {
                known << QString::fromLatin1(each.name);
            }
            return wrongArguments(QStringLiteral("--model must be one of %1, not '%2'")
                                      .arg(known.join(QStringLiteral(", ")), parser.value(model)));
        }
    }
    divergence::Limits& limits = choice.limits;
    if (!readLimit(parser, joint, std::numbers::pi / 180, limits.jointPosition) ||
        !readLimit(parser, tcp, 1e-3, limits.tcpPosition) || !readLimit(parser, current, 1, limits.current) ||
        !readLimit(parser, force, 1, limits.force) || !readLimit(parser, lasting, 1, limits.lasting) ||
        !readLimit(parser, from, 1, choice.from) || !readLimit(parser, until, 1, choice.until)) {
        return kWrongArguments;
    }
    const auto opened = recording::openRecording(parser.positionalArguments().constFirst());
    if (!opened) {
        return complain(opened.error().toString(), kFailed);
    }
    ProgressLine line(!parser.isSet(quiet));
    constexpr double kPercent = 100;
    choice.progress = [&line](double done) {
        line.show(QStringLiteral("compared %1 %").arg(done * kPercent, 0, 'f', 0));
        return true;
    };
    const auto report = divergence::compare(*opened.value(), choice);
    line.clear();
    if (!report) {
        return complain(report.error().toString(), kFailed);
    }
    if (parser.isSet(json)) {
        out() << QJsonDocument(toJson(*report)).toJson();
    } else {
        print(*report);
    }
    out().flush();
    for (const QString& problem : opened.value()->problems()) {
        complain(problem, kFailed);
    }
    return report->firstCompared && !report->first() && opened.value()->problems().isEmpty() ? kSuccess
                                                                                             : kFailed;
}

}  // namespace tiller::app
