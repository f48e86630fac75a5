// SPDX-License-Identifier: MIT
#pragma once

// Says which window has a project open. The lock file ".cell-7.tiller.lock" beside the project names its owner; the
// system releases it when the owner's process ends, also by kill -9, so that no stale lock remains. A lock can be taken
// over from a living owner, who can see that with isHeld().

#include <QDateTime>
#include <QString>
#include <memory>
#include <optional>

#include "robot/core/result.h"

namespace tiller::project {

/// Who has a project open.
struct LockOwner {
    QString user;
    QString host;
    QString program;
    qint64 process = 0;  ///< process id on `host`; 0 when unknown
    QDateTime since;
    /// For people: "anna on lab-3, tiller, process 4711".
    QString toString() const;
};

/// Threads  one at a time
class ProjectLock {
public:
    /// path  of the project; a symbolic link has the lock of its target
    explicit ProjectLock(const QString& path);
    ~ProjectLock();
    ProjectLock(const ProjectLock&) = delete;
    ProjectLock& operator=(const ProjectLock&) = delete;

    /// Takes the lock unless a living process holds it.
    /// Returns  the other owner when there is one; nothing when the lock is held, or when the file system offers none
    std::optional<LockOwner> acquire();
    /// Takes the lock also from a living owner.
    /// Errors   FileNotWritable, DiskFull
    Result<void> takeOver();
    /// Whether this object still holds the lock: false after another window has taken it over.
    bool isHeld() const;
    void release();  ///< Does nothing when the lock is not held.
    /// Where the file system offers no lock, acquire() reports no owner but isHeld() is false.
    QString path() const { return lockPath_; }

private:
    struct Handle;
    std::optional<LockOwner> readOwner() const;

    QString lockPath_;
    std::unique_ptr<Handle> handle_;
};

}  // namespace tiller::project
