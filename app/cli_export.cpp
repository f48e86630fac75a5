// SPDX-License-Identifier: GPL-3.0-or-later

#include <QCommandLineParser>
#include <QFileInfo>

#include "app/cli_command.h"
#include "app/cli_options.h"
#include "app/cli_progress.h"
#include "robot/recording/formats/export_recording.h"
#include "robot/recording/formats/file_formats.h"
#include "robot/recording/formats/open_recording.h"

namespace tiller::app {

namespace {

const QString kExportHelp = QStringLiteral(
    "tiller-cli export: exports a recording or a part of it for other programs\n"
    "\n"
    "Usage: tiller-cli export FILE --out FILE [options]\n"
    "\n"
    "  FILE                 recording (.mcap, .h5 or .csv); the format is detected from the content\n"
    "  --out FILE           FILE.csv, FILE.h5 (also .hdf5) for h5py, MATLAB and Octave, or FILE.mcap\n"
    "  --columns A,B,...    exports only these columns and the time column; the name of a field selects all\n"
    "                       its columns\n"
    "  --from SECONDS       start of the exported part, from the first row\n"
    "  --until SECONDS      end of the exported part, from the first row\n"
    "  --separator CHAR     column separator of a .csv file: , ; or tab (default ,)\n"
    "  --decimal CHAR       decimal sign of a .csv file: . or , (default .)\n"
    "  --units              adds a line of units below the header of a .csv file\n"
    "  --force              replaces an existing file\n"
    "  --quiet              shows no progress on the terminal\n"
    "  --help               shows this text\n"
    "\n"
    "Numbers are written with the fewest digits that read back exactly; values that the robot did not send\n"
    "are empty cells. Exit code: 0 everything was written, 1 not everything was written, or part of the\n"
    "recording could not be read, 2 invalid arguments.\n");

}  // namespace

int exportRecording(const QStringList& arguments) {
    QCommandLineParser parser;
    const QCommandLineOption help(QStringList{"h", "help"});
    const QCommandLineOption outFile("out", {}, "FILE");
    const QCommandLineOption columns("columns", {}, "A,B");
    const QCommandLineOption from("from", {}, "SECONDS", "0");
    const QCommandLineOption until("until", {}, "SECONDS", "1e12");
    const QCommandLineOption separator("separator", {}, "CHAR", ",");
    const QCommandLineOption decimal("decimal", {}, "CHAR", ".");
    const QCommandLineOption units("units");
    const QCommandLineOption force("force");
    const QCommandLineOption quiet("quiet");
    parser.addOptions({help, outFile, columns, from, until, separator, decimal, units, force, quiet});
    if (!parser.parse(arguments)) {
        return wrongArguments(parser.errorText());
    }
    if (parser.isSet(help)) {
        out() << kExportHelp;
        out().flush();
        return kSuccess;
    }
    if (parser.positionalArguments().size() != 1) {
        return wrongArguments(QStringLiteral("export: exactly one recording is required"));
    }
    const QString target = parser.value(outFile);
    if (!recording::canExportTo(target)) {
        return wrongArguments(
            target.isEmpty()
                ? QStringLiteral("export: --out FILE.csv, --out FILE.h5 or --out FILE.mcap is missing")
                : QStringLiteral("export: '%1' must end in %2").arg(target, recording::suffixWords(false)));
    }
    const QString source = parser.positionalArguments().constFirst();
    if (QFileInfo(source).canonicalFilePath() == QFileInfo(target).canonicalFilePath() &&
        QFileInfo::exists(target)) {
        return wrongArguments(QStringLiteral("export: the output file must differ from the recording"));
    }
    if (!parser.isSet(force) && QFileInfo::exists(target)) {
        return wrongArguments(QStringLiteral("export: %1 already exists; --force replaces it").arg(target));
    }
    const auto first = numberIn(parser, from, -1e12, 1e12);
    const auto last = numberIn(parser, until, -1e12, 1e12);
    if (!first || !last) {
        return kWrongArguments;
    }
    recording::CsvStyle style;
    const QString between = parser.value(separator);
    style.separator = between == QLatin1String("tab") || between == QLatin1String("\\t") ? '\t'
                      : between.size() == 1 ? between.at(0).toLatin1()
                                            : '\0';
    style.decimal = parser.value(decimal).size() == 1 ? parser.value(decimal).at(0).toLatin1() : '\0';
    style.unitsLine = parser.isSet(units);

    auto opened = recording::openRecording(source);
    if (!opened) {
        return complain(opened.error().toString(), kFailed);
    }
    const recording::Recording& file = *opened.value();
    recording::ExportChoice choice;
    choice.path = target;
    choice.columns = namesIn(parser.value(columns));
    choice.from = *first;
    choice.until = *last;
    ProgressLine line(!parser.isSet(quiet));
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

}  // namespace tiller::app
