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
         .open = &openCsv,
         .write = &exportCsv,
         .recorder = [](const McapFormatOptions& extras,
                        bool csvHead) { return csvFormat(csvHead ? extras.facts : Metadata()); },
         .isComplete = false},
        {.name = QStringLiteral("HDF5"),
         .suffixes = {QStringLiteral("h5"), QStringLiteral("hdf5")},
         .magic = "\x89HDF",
         .open = &openHdf5,
         .write = [](const Recording& recording, const ExportChoice& choice,
                     const CsvStyle&) { return exportHdf5(recording, choice); },
         .recorder = nullptr,
         .isComplete = false},
        {.name = QStringLiteral("MCAP"),
         .suffixes = {QStringLiteral("mcap")},
         .magic = "\x89MCAP",
         .open = [](const Text& path, const TableFormat&) { return openMcap(path); },
         .write = [](const Recording& recording, const ExportChoice& choice,
                     const CsvStyle&) { return exportMcap(recording, choice); },
         .recorder = [](const McapFormatOptions& extras, bool) { return mcapFormat(extras); },
         .isComplete = true},
    };
    return rows;
}

const FileFormat* fileFormatOf(const Text& path) {
    const QString suffix = QFileInfo(QString(path)).suffix().toLower();
    const std::vector<FileFormat>& rows = fileFormats();
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const FileFormat& format) { return format.suffixes.contains(suffix); });
    return row == rows.end() ? nullptr : &*row;
}

QString suffixWords(bool recorded) {
    QStringList suffixes;
    for (const FileFormat& format : fileFormats()) {
        if (!recorded || format.recorder != nullptr) {
            suffixes << QLatin1Char('.') + format.suffixes.constFirst();
        }
    }
    const QString end = suffixes.takeLast();
    return suffixes.join(QStringLiteral(", ")) + QStringLiteral(" or ") + end;
}

}  // namespace tiller::recording
