// SPDX-License-Identifier: GPL-3.0-or-later

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

/// Output format of a quantity: name, unit, and conversion factor from SI units.
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
                    {"model_confirmed", report.isModelConfirmed},
                    {"outcomes", outcomes}};
    if (report.otherModel) {
        all["other_model"] = robotModel(*report.otherModel).name;
    }
    if (const auto first = report.first()) {
        all["first"] = toJson(*first);
    }
    return all;
}

void print(const divergence::Report& report) {
    out() << QStringLiteral(
                 "%1 rows compared with the %2 model, %3 rows skipped (no power, guided by hand, or after a "
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
                  << QStringLiteral(": maximum %1, %2 at %3 s\n")
                         .arg(amountOf(*outcome.greatest), placeOf(*outcome.greatest))
                         .arg(outcome.greatest->seconds, 0, 'f', 3);
        }
        if (outcome.parted) {
            out() << QStringLiteral("    above the limit starting at %1 s (row %2): %3, up to %4\n")
                         .arg(outcome.parted->seconds, 0, 'f', 3)
                         .arg(outcome.parted->row)
                         .arg(placeOf(*outcome.parted), amountOf(*outcome.parted));
        }
    }
    if (report.otherModel) {
        out() << QStringLiteral("The recorded arm is a %1, not a %2. Compare with --model %1.\n")
                     .arg(QLatin1String(robotModel(*report.otherModel).name),
                          QLatin1String(robotModel(report.model).name));
    }
    const auto first = report.first();
    if (!first) {
        out() << (!report.firstCompared ? "nothing could be compared\n"
                  : report.otherModel   ? "no value is above its limit\n"
                  : !report.isModelConfirmed
                      ? "no value is above its limit, but the values may fit other models too\n"
                      : "arm and model agree\n");
        return;
    }
    out() << QStringLiteral("arm and model differ starting at %1 s: %2, %3 of %4\n")
                 .arg(first->seconds, 0, 'f', 3)
                 .arg(placeOf(*first), amountOf(*first), QLatin1String(spellingOf(first->quantity).name));
    if (report.partedFromStart()) {
        out() << "The arm deviates from the model from the start of the recording. Check --model, the "
                 "payload set on the "
                 "robot, and whether something was touching the arm.\n";
    }
}

int compare(const CommandArguments& arguments) {
    if (arguments.operands().size() != 1) {
        return wrongArguments(QStringLiteral("divergence: exactly one recording is required"));
    }
    divergence::Choice choice;
    if (arguments.isSet("model")) {
        choice.model = robotModelByName(arguments.value("model"));
        if (!choice.model) {
            QStringList known;
            for (const RobotModel& each : robotModels()) {
                known << QString::fromLatin1(each.name);
            }
            return wrongArguments(QStringLiteral("--model must be one of %1, not '%2'")
                                      .arg(known.join(QStringLiteral(", ")), arguments.value("model")));
        }
    }
    divergence::Limits& limits = choice.limits;
    const auto read = [&arguments](const char* option, double factor, double& value) {
        if (arguments.isSet(option)) {
            value = arguments.number(option) * factor;
        }
    };
    read("joint", std::numbers::pi / 180, limits.jointPosition);
    read("tcp", 1e-3, limits.tcpPosition);
    read("current", 1, limits.current);
    read("force", 1, limits.force);
    read("lasting", 1, limits.lasting);
    read("from", 1, choice.from);
    read("until", 1, choice.until);
    const auto format = tableFormatOf(arguments);
    if (!format) {
        return wrongArguments(format.error().context);
    }
    const auto opened = recording::openRecording(arguments.operands().constFirst(), *format);
    if (!opened) {
        return complain(opened.error().toString(), exitCodeOf(opened.error()));
    }
    ProgressLine line(!arguments.isSet("quiet"));
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
    if (arguments.isSet("json")) {
        out() << QJsonDocument(toJson(*report)).toJson();
    } else {
        print(*report);
    }
    out().flush();
    for (const QString& problem : opened.value()->problems()) {
        complain(problem, kFailed);
    }
    const bool agrees = report->firstCompared && !report->first() && !report->otherModel;
    return agrees && opened.value()->problems().isEmpty() ? kSuccess : kFailed;
}

}  // namespace

const Command& divergenceCommand() {
    constexpr double kMaxLimit = 1e6;
    static const Command kCommand{
        .name = "divergence",
        .operands = "FILE",
        .summary = "compares the motion of an arm with its model",
        .title = "compares the motion of an arm with its model",
        .usage = {"FILE [options]"},
        .operandRows = {recordingOperand("FILE")},
        .options = withTableOptions(
            {{"model", "MODEL", "robot model, such as ur5e (default: the model named in the recording)"},
             {"joint",
              "DEGREES",
              "maximum permitted deviation of each joint (default 0.5); 0: not compared",
              "",
              {0, kMaxLimit}},
             {"tcp",
              "MM",
              "maximum permitted deviation of the TCP position (default 5); 0: not compared",
              "",
              {0, kMaxLimit}},
             {"current",
              "A",
              "maximum permitted deviation of each joint current (default 2); 0: not compared",
              "",
              {0, kMaxLimit}},
             {"force",
              "N",
              "maximum permitted deviation of the TCP force (default 30); 0: not compared",
              "",
              {0, kMaxLimit}},
             {"lasting",
              "SECONDS",
              "ignores deviations shorter than this time (default 0.01)",
              "",
              {0, kMaxLimit}},
             {"from", "SECONDS", "start of the compared time range", "", {0, kMaxLimit}},
             {"until", "SECONDS", "end of the compared time range", "", {0, kMaxLimit}},
             {"json", "", "prints one JSON object instead of text"},
             {"quiet", "", "shows no progress on the terminal"}}),
        .notes =
            "The simulated arm follows the targets in the recording, and its motion is compared with the "
            "motion of the real arm. The simulated arm carries the payload that is set on the controller, "
            "and "
            "has neither contact nor friction. Exit code: 0 no value is above its limit, 1 the arm and the "
            "model differ or cannot be compared, "
            "2 invalid arguments.",
        .run = compare};
    return kCommand;
}

}  // namespace tiller::app
