// SPDX-License-Identifier: MIT
#pragma once

// File access of the recorder. Every step that can fail reports errors, including syncing and closing,
// because a disk or network share may accept data and lose them later. Private to robot/recording.

#include <QString>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

#include "robot/core/result.h"

namespace tiller::recording {

/// Threads  one at a time
/// Errors   of every call: DiskFull, FileNotWritable; the context contains the file name, and
///          controllerMessage contains the system's message
class RecordingFile {
public:
    virtual ~RecordingFile() = default;

    /// Creates or truncates the file, and syncs its directory entry before returning.
    virtual Result<void> open(const QString& path) = 0;
    /// Appends text.
    /// written  number of bytes written, even on failure
    virtual Result<void> write(std::string_view text, std::size_t& written) = 0;
    /// Syncs all written data to the disk. Also fails if the file was deleted.
    virtual Result<void> sync() = 0;
    /// Truncates the file to this size, if possible.
    virtual void cut(std::int64_t bytes) = 0;
    virtual Result<void> close() = 0;
};

using RecordingFileFactory = std::function<std::unique_ptr<RecordingFile>()>;

/// A file in the file system of the operating system.
std::unique_ptr<RecordingFile> systemFile();

}  // namespace tiller::recording
