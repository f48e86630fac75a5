// SPDX-License-Identifier: MIT
#pragma once

// Protects unsaved work: a copy of a sample project, a project whose file cannot be written, or changes in a
// window that must not save. Each window stores its work in an application folder, so that the work survives
// a crash or closing the window. Tiller offers to restore it at the next start.

#include <QDateTime>
#include <QList>
#include <QString>
#include <cstdint>
#include <mutex>
#include <optional>

#include "robot/project/project_file.h"
#include "robot/project/project_lock.h"

namespace tiller::project {

/// Unsaved work of a closed window.
struct KeptCopy {
    QString file;  ///< path of the copy
    QString name;  ///< display name of the project
    QDateTime at;  ///< time of the last change
};

/// Stores a copy of the unsaved work of one window.
/// Threads  any. Blocks: for the file system. Real-time: no
class CopyKeeper {
public:
    /// folder  created when needed; empty: no copies are kept
    explicit CopyKeeper(const QString& folder);

    /// Continues a kept copy. The next keep() replaces the copy, and saving the work removes it. If another
    /// window continues the same copy, this object uses a separate copy.
    void adopt(const KeptCopy& copy);
    /// revision  increases with every change of the document; older revisions are ignored
    /// Errors    FileNotWritable, DiskFull
    Result<void> keep(const Project& project, const QString& name, std::uint64_t revision);
    /// Removes the copy when the work up to `revision` has been saved or the user has discarded it.
    void remove(std::uint64_t revision);

private:
    QString folder_;
    std::mutex mutex_;
    QString file_;  ///< empty if there is no copy
    std::optional<ProjectLock> lock_;
    std::optional<std::uint64_t> revision_;  ///< newest revision passed to keep() or remove()
    bool removed_ = false;                   ///< remove() was called for this revision
};

/// Copies of closed windows in the folder, newest first.
/// Threads  any. Blocks: for the file system. Real-time: no
QList<KeptCopy> keptCopies(const QString& folder);
/// Errors   as for loadProject()
Result<Project> loadKeptCopy(const KeptCopy& copy);

}  // namespace tiller::project
