// SPDX-License-Identifier: MIT
#include "robot/recording/formats/open_recording.h"

#include <QFile>

#include "robot/core/file_reading.h"
#include "robot/recording/formats/file_formats.h"

namespace tiller::recording {

Result<std::unique_ptr<Recording>> openRecording(const Text& path, const TableFormat& format) {
    QFile file;
    if (const Result<void> opened = openForReading(file, path); !opened) {
        return opened.error();
    }
    const QByteArray begin = file.read(8);
    file.close();
    return fileFormatOfContent(begin).open(path, format);
}

Result<std::shared_ptr<const RecordingFormat>> formatForPath(const Text& path) {
    const FileFormat* format = fileFormatOf(path);
    if (format != nullptr && format->recorder != nullptr) {
        return format->recorder({}, false);
    }
    return Error{ErrorCode::InvalidArgument, QString(path),
                 QStringLiteral("path: must end in ") + suffixWords(FormatSet::Recorded)};
}

}  // namespace tiller::recording
