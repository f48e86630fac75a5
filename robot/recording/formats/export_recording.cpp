// SPDX-License-Identifier: MIT
#include "robot/recording/formats/export_recording.h"

#include "robot/recording/hdf5/hdf5_export.h"
#include "robot/recording/mcap/mcap_export.h"

namespace tiller::recording {

namespace {

bool endsIn(const QString& path, const char* suffix) {
    return path.endsWith(QLatin1String(suffix), Qt::CaseInsensitive);
}

}  // namespace

bool canExportTo(const Text& path) {
    return endsIn(path, ".csv") || endsIn(path, ".h5") || endsIn(path, ".hdf5") || endsIn(path, ".mcap");
}

Result<ExportReport> exportRecording(const Recording& recording, const ExportChoice& choice,
                                     const CsvStyle& style) {
    if (endsIn(choice.path, ".csv")) {
        return exportCsv(recording, choice, style);
    }
    if (endsIn(choice.path, ".h5") || endsIn(choice.path, ".hdf5")) {
        return exportHdf5(recording, choice);
    }
    if (endsIn(choice.path, ".mcap")) {
        return exportMcap(recording, choice);
    }
    return Error{ErrorCode::InvalidArgument, QStringLiteral("export to %1").arg(choice.path),
                 QStringLiteral("path: must end in .csv, .h5, .hdf5 or .mcap")};
}

}  // namespace tiller::recording
