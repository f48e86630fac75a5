// SPDX-License-Identifier: GPL-3.0-or-later

#include <QDateTime>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTimeZone>

#include "app/cli_command.h"
#include "app/cli_options.h"
#include "robot/recording/formats/open_recording.h"

namespace tiller::app {

namespace {

double lengthOf(const recording::Recording& file) {
    const auto last = file.rows() == 0 ? Result<std::vector<double>>(std::vector<double>{0.0})
                                       : file.times({file.rows() - 1, 1});
    return last && !last.value().empty() ? last.value().front() : 0;
}

QJsonValue timeColumnOf(const recording::Recording& file) {
    const auto column = file.timeColumn();
    return column ? QJsonValue(QString::fromStdString(file.columns()[*column].name)) : QJsonValue();
}

QString startOf(const recording::Recording& file) {
    const auto start = file.startUtcNs();
    constexpr std::int64_t kNsPerMs = 1'000'000;
    return start ? QDateTime::fromMSecsSinceEpoch(*start / kNsPerMs, QTimeZone::utc())
                       .toString(Qt::ISODateWithMs)
                 : QString();
}

QJsonObject toJson(const recording::Recording& file) {
    QJsonArray columns;
    for (const recording::RecordedColumn& column : file.columns()) {
        columns.append(QJsonObject{{"name", QString::fromStdString(column.name)},
                                   {"unit", QString::fromStdString(column.unit)},
                                   {"whole", column.whole}});
    }
    QJsonArray gaps;
    for (const recording::RecordedGap& gap : file.gaps()) {
        gaps.append(QJsonObject{{"row", static_cast<double>(gap.row)},
                                {"packets", static_cast<double>(gap.packets)},
                                {"seconds", gap.seconds}});
    }
    QJsonObject facts;
    for (const auto& [key, value] : file.facts()) {
        facts[QString::fromStdString(key)] = QString::fromStdString(value);
    }
    QJsonArray events;
    for (const recording::RecordedEvent& event : file.events()) {
        events.append(QJsonObject{{"seconds", event.seconds},
                                  {"level", event.level},
                                  {"source", event.source},
                                  {"text", event.text}});
    }
    return {{"path", file.path()},
            {"format", file.format()},
            {"rows", static_cast<double>(file.rows())},
            {"seconds", lengthOf(file)},
            {"start", startOf(file)},
            {"period", file.period()},
            {"time_column", timeColumnOf(file)},
            {"columns", columns},
            {"gaps", gaps},
            {"facts", facts},
            {"events", events},
            {"attachments", QJsonArray::fromStringList(file.attachments())},
            {"problems", QJsonArray::fromStringList(file.problems())}};
}

void print(const recording::Recording& file) {
    out() << QStringLiteral("%1: %2, %3 rows, %4 s\n")
                 .arg(file.path(), file.format())
                 .arg(file.rows())
                 .arg(lengthOf(file), 0, 'f', 3);
    if (const QString start = startOf(file); !start.isEmpty()) {
        out() << "started " << start << '\n';
    }
    if (const auto time = file.timeColumn()) {
        out() << "time: column " << QString::fromStdString(file.columns()[*time].name) << '\n';
    }
    for (const auto& [key, value] : file.facts()) {
        out() << QString::fromStdString(key) << ": " << QString::fromStdString(value) << '\n';
    }
    for (const QString& name : file.attachments()) {
        out() << "attachment: " << name << '\n';
    }
    std::uint64_t missing = 0;
    for (const recording::RecordedGap& gap : file.gaps()) {
        missing += gap.packets;
    }
    out() << QStringLiteral("%1 gaps, %2 packets missing\n").arg(file.gaps().size()).arg(missing);
    constexpr std::size_t kMaxGaps = 10;
    for (std::size_t i = 0; i < file.gaps().size() && i < kMaxGaps; ++i) {
        const recording::RecordedGap& gap = file.gaps()[i];
        out() << QStringLiteral("  before row %1: %2 packets, %3 s\n")
                     .arg(gap.row)
                     .arg(gap.packets)
                     .arg(gap.seconds, 0, 'f', 3);
    }
    for (const recording::RecordedEvent& event : file.events()) {
        out()
            << QStringLiteral("  %1 s  %2: %3\n").arg(event.seconds, 0, 'f', 3).arg(event.source, event.text);
    }
    out() << QStringLiteral("%1 columns:\n").arg(file.columns().size());
    for (const recording::RecordedColumn& column : file.columns()) {
        out() << "  " << QString::fromStdString(column.name);
        if (!column.unit.empty()) {
            out() << " [" << QString::fromStdString(column.unit) << ']';
        }
        out() << '\n';
    }
}

int info(const CommandArguments& arguments) {
    if (arguments.operands().size() != 1) {
        return wrongArguments(QStringLiteral("info: exactly one file is required"));
    }
    const auto format = tableFormatOf(arguments);
    if (!format) {
        return wrongArguments(format.error().context);
    }
    auto opened = recording::openRecording(arguments.operands().constFirst(), *format);
    if (!opened) {
        return complain(opened.error().toString(), exitCodeOf(opened.error()));
    }
    const recording::Recording& file = *opened.value();
    // Damaged parts are detected only when they are read.
    std::vector<std::size_t> first{0};
    constexpr std::uint64_t kRowsAtOnce = 65536;
    for (std::uint64_t row = 0; row < file.rows(); row += kRowsAtOnce) {
        if (const auto read = file.read(first, {row, kRowsAtOnce}); !read) {
            return complain(read.error().toString(), kFailed);
        }
    }
    if (arguments.isSet("json")) {
        out() << QJsonDocument(toJson(file)).toJson();
    } else {
        print(file);
    }
    out().flush();
    for (const QString& problem : file.problems()) {
        complain(problem, kFailed);
    }
    return file.problems().isEmpty() ? kSuccess : kFailed;
}

}  // namespace

const Command& infoCommand() {
    static const Command kCommand{
        .name = "info",
        .operands = "FILE",
        .summary = "describes the content of a recording",
        .title = "describes the content of a recording",
        .usage = {"FILE [options]"},
        .operandRows = {recordingOperand("FILE")},
        .options = withTableOptions({{"json", "", "prints one JSON object instead of text"}}),
        .notes =
            "Exit code: 0 the whole file was read, 1 the file or a part of the file could not be read, 2 "
            "invalid arguments.",
        .run = info};
    return kCommand;
}

}  // namespace tiller::app
