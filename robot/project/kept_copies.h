// SPDX-License-Identifier: MIT
#pragma once

// Work that is in no project file yet: a copy of a sample, a project whose file cannot be written, changes in a window
// that must not save. A window keeps it in a folder of the program, so that a crash or a closed window loses none of it;
// the next start offers what was kept.

#include <QDateTime>
#include <QList>
#include <QString>
#include <cstdint>
#include <mutex>
#include <optional>

#include "robot/project/project_file.h"
#include "robot/project/project_lock.h"

namespace tiller::project {

/// Unsaved work that a window which has ended left behind.
struct KeptCopy {
    QString file;  ///< where it is kept
    QString name;  ///< of the project, for people
    QDateTime at;  ///< of its last change
};

/// The unsaved work of one window.
/// Threads  any. Blocks: for the file system. Real-time: no
class CopyKeeper {
public:
    /// folder  is created when needed; empty: nothing is kept
    explicit CopyKeeper(const QString& folder);

    /// Continues a kept copy: it is replaced by what is kept next, and removed when that is saved. When another window
    /// continues the same copy, this one keeps a copy of its own.
    void adopt(const KeptCopy& copy);
    /// revision  increases with every change of the document; older ones than the last one given are ignored
    /// Errors    FileNotWritable, DiskFull
    Result<void> keep(const Project& project, const QString& name, std::uint64_t revision);
    /// The work up to `revision` is saved, or discarded by the operator.
    void remove(std::uint64_t revision);

private:
    QString folder_;
    std::mutex mutex_;
    QString file_;  ///< empty while nothing is kept
    std::optional<ProjectLock> lock_;
    std::optional<std::uint64_t> revision_;  ///< of the last call
    bool removed_ = false;                   ///< the last call was remove()
};

/// What windows that have ended left behind in the folder, newest first.
/// Threads  any. Blocks: for the file system. Real-time: no
QList<KeptCopy> keptCopies(const QString& folder);
/// Errors   as loadProject()
Result<Project> loadKeptCopy(const KeptCopy& copy);

}  // namespace tiller::project
