// SPDX-License-Identifier: MIT
#include "robot/recording/formats/export_recording.h"

#include "robot/recording/formats/file_formats.h"

namespace tiller::recording {

bool canExportTo(const Text& path) {
    return fileFormatOf(path) != nullptr;
}

Result<ExportReport> exportRecording(const Recording& recording, const ExportChoice& choice,
                                     const CsvStyle& style) {
    if (const FileFormat* format = fileFormatOf(choice.path)) {
        return format->write(recording, choice, style);
    }
    return Error{ErrorCode::InvalidArgument, QStringLiteral("export to %1").arg(choice.path),
                 QStringLiteral("path: must end in ") + suffixWords(FormatSet::All)};
}

}  // namespace tiller::recording
