// SPDX-License-Identifier: MIT
#pragma once

// The file a recording goes to, as the recorder needs it: every step that can fail says so, writing back and
// closing included, because a disk or a network share may take bytes and lose them only then. Private to this
// room.

#include <QString>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

#include "robot/core/result.h"

namespace tiller::recording {

/// Threads  one at a time
/// Errors   of every call: DiskFull, FileNotWritable; the context names the file, controllerMessage is what
/// the
///          system says
class RecordingFile {
public:
    virtual ~RecordingFile() = default;

    /// Makes the file, or empties the one there is, and has its name on the disk before it returns.
    virtual Result<void> open(const QString& path) = 0;
    /// Appends; written  how much of it got through, also where it failed
    virtual Result<void> write(std::string_view text, std::size_t& written) = 0;
    /// What was written is on the disk afterwards.
    virtual Result<void> sync() = 0;
    /// Cuts the file to so many bytes, as well as it can be done.
    virtual void cut(std::int64_t bytes) = 0;
    virtual Result<void> close() = 0;
};

using RecordingFileFactory = std::function<std::unique_ptr<RecordingFile>()>;

/// A file of the system.
std::unique_ptr<RecordingFile> systemFile();

}  // namespace tiller::recording
