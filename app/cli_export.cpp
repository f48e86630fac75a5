// SPDX-License-Identifier: GPL-3.0-or-later

#include <QFileInfo>

#include "app/cli_command.h"
#include "app/cli_options.h"
#include "app/cli_progress.h"
#include "robot/recording/formats/export_recording.h"
#include "robot/recording/formats/file_formats.h"
#include "robot/recording/formats/open_recording.h"

namespace tiller::app {

namespace {

using recording::FormatSet;

int exportFile(const CommandArguments& arguments) {
    if (arguments.operands().size() != 1) {
        return wrongArguments(QStringLiteral("export: exactly one recording is required"));
    }
    const QString target = arguments.value("out");
    if (!recording::canExportTo(target)) {
        return wrongArguments(
            target.isEmpty() ? QStringLiteral("export: %1 is missing")
                                   .arg(recording::suffixWords(FormatSet::All, QStringLiteral("--out FILE")))
                             : QStringLiteral("export: '%1' must end in %2")
                                   .arg(target, recording::suffixWords(FormatSet::All)));
    }
    const QString source = arguments.operands().constFirst();
    if (QFileInfo(source).canonicalFilePath() == QFileInfo(target).canonicalFilePath() &&
        QFileInfo::exists(target)) {
        return wrongArguments(QStringLiteral("export: the output file must differ from the recording"));
    }
    if (!arguments.isSet("force") && QFileInfo::exists(target)) {
        return wrongArguments(QStringLiteral("export: %1 already exists; --force replaces it").arg(target));
    }
    recording::CsvStyle style;
    const QString between = arguments.value("separator");
    style.separator = between == QLatin1String("tab") || between == QLatin1String("\\t") ? '\t'
                      : between.size() == 1 ? between.at(0).toLatin1()
                                            : '\0';
    style.decimal =
        arguments.value("decimal").size() == 1 ? arguments.value("decimal").at(0).toLatin1() : '\0';
    style.unitsLine = arguments.isSet("units");
    style.head = arguments.isSet("head");

    const auto format = tableFormatOf(arguments);
    if (!format) {
        return wrongArguments(format.error().context);
    }
    auto opened = recording::openRecording(source, *format);
    if (!opened) {
        return complain(opened.error().toString(), exitCodeOf(opened.error()));
    }
    const recording::Recording& file = *opened.value();
    recording::ExportChoice choice;
    choice.path = target;
    choice.columns = namesIn(arguments.value("columns"));
    choice.from = arguments.number("from");
    choice.until = arguments.number("until");
    ProgressLine line(!arguments.isSet("quiet"));
    choice.progress = [&line](double done) {
        constexpr double kPercent = 100;
        line.show(QStringLiteral("%1 %").arg(done * kPercent, 0, 'f', 0));
        return true;
    };
    const auto report = recording::exportRecording(file, choice, style);
    line.clear();
    if (!report) {
        const bool theirs = report.error().code == ErrorCode::InvalidArgument ||
                            report.error().code == ErrorCode::FieldUnknown;
        return complain(report.error().toString(), theirs ? kWrongArguments : kFailed);
    }
    out() << QStringLiteral("%1: %2 rows, %3 bytes")
                 .arg(target)
                 .arg(report.value().rows)
                 .arg(report.value().bytes)
          << Qt::endl;
    for (const QString& problem : file.problems()) {
        complain(problem, kFailed);
    }
    return file.problems().isEmpty() ? kSuccess : kFailed;
}

}  // namespace

const Command& exportCommand() {
    static const Command kCommand{
        .name = "export",
        .operands = "FILE",
        .summary = "exports a recording in another format (see 'tiller-cli export --help')",
        .title = "exports a recording or a part of it for other programs",
        .usage = {"FILE --out FILE [options]"},
        .operandRows = {recordingOperand("FILE")},
        .options = withTableOptions(
            {{"out", "FILE", QStringLiteral("output file: %1").arg(recording::suffixHelp(FormatSet::All))},
             {"columns", "A,B,...",
              "exports only these columns and the time column; the name of a field selects "
              "all its columns"},
             {"from",
              "SECONDS",
              "start of the exported time range, relative to the first row",
              "0",
              {-1e12, 1e12}},
             {"until",
              "SECONDS",
              "end of the exported time range, relative to the first row",
              "1e12",
              {-1e12, 1e12}},
             {"separator", "CHAR", "column separator of a .csv file: , ; or tab (default %1)", ","},
             {"decimal", "CHAR", "decimal separator of a .csv file: . or , (default %1)", "."},
             {"units", "", "adds a line of units below the header of a .csv file"},
             {"head", "",
              "writes the start time, metadata and units at the top of a .csv file, in lines that begin "
              "with # (pandas: comment='#')"},
             {"force", "", "replaces an existing file"},
             {"quiet", "", "shows no progress on the terminal"}}),
        .notes =
            "Numbers are written with the fewest digits that preserve the exact value; values that the robot "
            "did not send are empty cells. Exit code: 0 everything was written, 1 not everything was "
            "written, or part of the recording could not be read, 2 invalid arguments.",
        .run = exportFile};
    return kCommand;
}

}  // namespace tiller::app
