// SPDX-License-Identifier: MIT
#include "robot/recording/formats/open_recording.h"

#include <QFile>

#include "robot/core/file_reading.h"
#include "robot/recording/csv_recording.h"
#include "robot/recording/hdf5/hdf5_recording.h"
#include "robot/recording/mcap/mcap_format.h"
#include "robot/recording/mcap/mcap_recording.h"

namespace tiller::recording {

Result<std::unique_ptr<Recording>> openRecording(const Text& path) {
    QFile file;
    if (const Result<void> opened = openForReading(file, path); !opened) {
        return opened.error();
    }
    const QByteArray begin = file.read(8);
    file.close();
    if (begin.startsWith("\x89MCAP")) {
        return openMcap(path);
    }
    if (begin.startsWith("\x89HDF")) {
        return openHdf5(path);
    }
    return openCsv(path);
}

Result<std::shared_ptr<const RecordingFormat>> formatForPath(const Text& path) {
    const QString name = path;
    if (name.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive)) {
        return csvFormat();
    }
    if (name.endsWith(QLatin1String(".mcap"), Qt::CaseInsensitive)) {
        return mcapFormat();
    }
    return Error{ErrorCode::InvalidArgument, QStringLiteral("record to %1").arg(name),
                 QStringLiteral("path: must end in .csv or .mcap")};
}

}  // namespace tiller::recording
