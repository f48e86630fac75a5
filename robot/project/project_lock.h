// SPDX-License-Identifier: MIT
#pragma once

// Shows which window has a project open. The lock file ".cell-7.tiller.lock" in the same folder contains the
// name of its owner. The system releases the lock when the owner's process ends, even by kill -9, so no stale
// lock remains. A lock can be taken over from a running owner, which can detect the loss with isHeld().

#include <QDateTime>
#include <QString>
#include <memory>
#include <optional>

#include "robot/core/result.h"

namespace tiller::project {

/// Owner of a lock.
struct LockOwner {
    QString user;
    QString host;
    QString program;
    qint64 process = 0;  ///< process ID on `host`; 0: unknown
    QDateTime since;
    /// Text for users, e.g. "anna on lab-3, tiller, process 4711".
    QString toString() const;
};

/// Threads  one at a time
class ProjectLock {
public:
    /// path  path of the project; a symbolic link uses the lock of its target
    explicit ProjectLock(const QString& path);
    ~ProjectLock();
    ProjectLock(const ProjectLock&) = delete;
    ProjectLock& operator=(const ProjectLock&) = delete;

    /// Takes the lock unless a running process holds it.
    /// Returns  the other owner, if any; empty if the lock was taken, or if the file system does not support
    ///          locks
    std::optional<LockOwner> acquire();
    /// Takes the lock even if a running process holds it.
    /// Errors   FileNotWritable, DiskFull
    Result<void> takeOver();
    /// False after another window has taken over the lock, and on a file system without locks.
    bool isHeld() const;
    void release();  ///< No effect if the lock is not held.
    QString path() const { return lockPath_; }

private:
    struct Handle;
    std::optional<LockOwner> readOwner() const;

    QString lockPath_;
    std::unique_ptr<Handle> handle_;
};

}  // namespace tiller::project
