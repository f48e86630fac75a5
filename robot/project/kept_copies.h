// SPDX-License-Identifier: MIT
#pragma once

// Protects unsaved work: a copy of a sample project, a project whose file cannot be written, or changes in a
// window that must not save. Each window stores its work in an application folder, so the work survives a
// crash or a closed window. The next start offers to restore it.

#include <QDateTime>
#include <QList>
#include <QString>
#include <cstdint>
#include <mutex>
#include <optional>

#include "robot/project/project_file.h"
#include "robot/project/project_lock.h"

namespace tiller::project {

/// Unsaved work of a window that was closed.
struct KeptCopy {
    QString file;  ///< path of the copy
    QString name;  ///< display name of the project
    QDateTime at;  ///< time of the last change
};

/// Stores a copy of the unsaved work of one window.
/// Threads  any. Blocks: for the file system. Real-time: no
class CopyKeeper {
public:
    /// folder  created when needed; empty: no copies
    explicit CopyKeeper(const QString& folder);

    /// Continues a kept copy. The next keep() replaces the copy; it is removed when the work is saved. If
    /// another window continues the same copy, this object uses a separate one.
    void adopt(const KeptCopy& copy);
    /// revision  increases with every change of the document; revisions older than the last one are ignored
    /// Errors    FileNotWritable, DiskFull
    Result<void> keep(const Project& project, const QString& name, std::uint64_t revision);
    /// Removes the copy after the work up to `revision` was saved, or discarded by the user.
    void remove(std::uint64_t revision);

private:
    QString folder_;
    std::mutex mutex_;
    QString file_;  ///< empty if there is no copy
    std::optional<ProjectLock> lock_;
    std::optional<std::uint64_t> revision_;  ///< newest revision passed to keep() or remove()
    bool removed_ = false;                   ///< whether remove() was called for this revision
};

/// Copies of closed windows in the folder, newest first.
/// Threads  any. Blocks: for the file system. Real-time: no
QList<KeptCopy> keptCopies(const QString& folder);
/// Errors   as loadProject()
Result<Project> loadKeptCopy(const KeptCopy& copy);

}  // namespace tiller::project
