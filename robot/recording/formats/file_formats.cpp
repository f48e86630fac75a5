// SPDX-License-Identifier: MIT
#include "robot/recording/formats/file_formats.h"

#include <QFileInfo>
#include <algorithm>

#include "robot/recording/csv_recording.h"
#include "robot/recording/hdf5/hdf5_export.h"
#include "robot/recording/hdf5/hdf5_recording.h"
#include "robot/recording/mcap/mcap_export.h"
#include "robot/recording/mcap/mcap_recording.h"

namespace tiller::recording {

const std::vector<FileFormat>& fileFormats() {
    static const std::vector<FileFormat> rows = {
        {.name = QStringLiteral("CSV"),
         .suffixes = {QStringLiteral("csv")},
         .magic = {},
         .readers = QStringLiteral("pandas and spreadsheets"),
         .label = QT_TRANSLATE_NOOP("tiller::PlotDock", "CSV: text, for pandas and spreadsheets"),
         .open = &openCsv,
         .write = &exportCsv,
         .recorder = [](const McapFormatOptions& extras,
                        bool csvHead) { return csvFormat(csvHead ? extras.facts : Metadata()); },
         .isComplete = false},
        {.name = QStringLiteral("HDF5"),
         .suffixes = {QStringLiteral("h5"), QStringLiteral("hdf5")},
         .magic = "\x89HDF",
         .readers = QStringLiteral("h5py, MATLAB and Octave"),
         .label = nullptr,
         .open = &openHdf5,
         .write = [](const Recording& recording, const ExportChoice& choice,
                     const CsvStyle&) { return exportHdf5(recording, choice); },
         .recorder = nullptr,
         .isComplete = false},
        {.name = QStringLiteral("MCAP"),
         .suffixes = {QStringLiteral("mcap")},
         .magic = "\x89MCAP",
         .readers = QStringLiteral("ROS tools"),
         .label = QT_TRANSLATE_NOOP("tiller::PlotDock",
                                    "MCAP: every field, the log and the project, for ROS tools"),
         .open = [](const Text& path, const TableFormat&) { return openMcap(path); },
         .write = [](const Recording& recording, const ExportChoice& choice,
                     const CsvStyle&) { return exportMcap(recording, choice); },
         .recorder = [](const McapFormatOptions& extras, bool) { return mcapFormat(extras); },
         .isComplete = true},
    };
    return rows;
}

std::vector<const FileFormat*> formatsIn(FormatSet set) {
    std::vector<const FileFormat*> found;
    for (const FileFormat& format : fileFormats()) {
        const bool isRecorded = format.recorder != nullptr;
        const bool isFound = set == FormatSet::Recorded   ? isRecorded
                             : set == FormatSet::Complete ? isRecorded && format.isComplete
                             : set == FormatSet::Selected ? isRecorded && !format.isComplete
                                                          : true;
        if (isFound) {
            found.push_back(&format);
        }
    }
    return found;
}

const FileFormat* fileFormatOf(const Text& path) {
    const QString suffix = QFileInfo(QString(path)).suffix().toLower();
    const std::vector<FileFormat>& rows = fileFormats();
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const FileFormat& format) { return format.suffixes.contains(suffix); });
    return row == rows.end() ? nullptr : &*row;
}

const FileFormat& fileFormatOfContent(const QByteArray& begin) {
    const std::vector<FileFormat>& rows = fileFormats();
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const FileFormat& format) {
        return !format.magic.isEmpty() && begin.startsWith(format.magic);
    });
    return row != rows.end() ? *row : *std::find_if(rows.begin(), rows.end(), [](const FileFormat& format) {
        return format.magic.isEmpty();
    });
}

namespace {

QString listed(QStringList words, const QString& lastSeparator) {
    const QString last = words.takeLast();
    return words.isEmpty() ? last : words.join(QStringLiteral(", ")) + lastSeparator + last;
}

}  // namespace

QString suffixWords(FormatSet set, const QString& before) {
    QStringList words;
    for (const FileFormat* format : formatsIn(set)) {
        words << before + QLatin1Char('.') + format->suffixes.constFirst();
    }
    return listed(words, QStringLiteral(" or "));
}

QString suffixHelp(FormatSet set) {
    QStringList words;
    for (const FileFormat* format : formatsIn(set)) {
        words << QStringLiteral(".%1 for %2")
                     .arg(format->suffixes.join(QStringLiteral(" or .")), format->readers);
    }
    return listed(words, QStringLiteral(", or "));
}

QString suffixFilter(FormatSet set) {
    QStringList filters;
    for (const FileFormat* format : formatsIn(set)) {
        for (const QString& suffix : format->suffixes) {
            filters << QStringLiteral("*.") + suffix;
        }
    }
    return filters.join(QLatin1Char(' '));
}

}  // namespace tiller::recording
