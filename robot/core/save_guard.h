// SPDX-License-Identifier: MIT
#pragma once

// Locks a folder against other Tiller processes while this process compares a file with the version that it
// has read, and replaces the file. The system releases the lock when the process ends for any reason.

#include <QString>
#include <memory>

#include "robot/core/result.h"

namespace tiller {

/// A thread holds the guard only for milliseconds. On file systems without locks, the guard always succeeds,
/// and only the comparison before the write protects the file.
class SaveGuard {
public:
    /// Waits until no other process or thread holds the guard for the folder of `path`.
    /// Errors   FileNotWritable after 3 s
    /// Threads  any. Blocks: up to 3 s. Real-time: no
    static Result<std::unique_ptr<SaveGuard>> acquire(const QString& path);
    ~SaveGuard();
    SaveGuard(const SaveGuard&) = delete;
    SaveGuard& operator=(const SaveGuard&) = delete;

private:
    struct Handle;
    explicit SaveGuard(std::unique_ptr<Handle> handle);
    std::unique_ptr<Handle> handle_;
};

}  // namespace tiller
