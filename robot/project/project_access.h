// SPDX-License-Identifier: MIT
#pragma once

// One window's access to a project file that other windows, computers and programs can open and change as well. It
// holds the lock, remembers which content this window has read or written, and never replaces any other content.

#include <QByteArray>
#include <QList>
#include <QString>
#include <cstdint>
#include <mutex>
#include <optional>

#include "robot/project/project_file.h"
#include "robot/project/project_lock.h"

namespace tiller::project {

class ProjectAccess {
public:
    enum class Outcome {
        Saved,
        OpenElsewhere,   ///< not saved: another window holds the lock
        ChangedByOther,  ///< not saved: the file holds something this window has not read
    };
    struct SaveResult {
        Outcome outcome = Outcome::Saved;
        QString keptCopy;  ///< of a damaged file that was replaced; empty if there was none
    };
    struct Check {
        std::optional<LockOwner> owner;  ///< the other window that has the project open
        bool changedByOther = false;     ///< the file holds something this window has not read
        QByteArray fingerprint;          ///< of the file now; empty when it is missing or unreadable
    };

    /// path  need not exist. The file is touched by the calls below only.
    explicit ProjectAccess(const QString& path);

    // Threads  any, for all calls. Blocks: for the file system, and for other calls of the same object. Real-time: no

    /// Takes the lock if no other window holds it, and reads the file. saves then expect the content read.
    /// replaced  revision of the document that the content replaces: saves of it and of older ones, which may still wait
    ///           in another thread, are skipped
    /// Errors    as loadProject()
    Result<Project> load(std::optional<std::uint64_t> replaced = std::nullopt);
    /// As load(), for a damaged file.
    /// Errors   as recoverProject()
    Result<RecoveredProject> recover();
    /// Takes the lock for a file that does not exist yet: the first save must find none.
    void start();
    /// Takes the lock for a file that the operator agreed to replace.
    void replaceAny();
    /// Writes the project unless another window holds the lock or the file was changed by another program.
    /// revision  increases with every change of the document; older ones than the last saved are skipped
    /// Errors    as saveProject()
    Result<SaveResult> save(const Project& project, std::uint64_t revision);
    /// Whether saving would work now. Takes the lock when its owner has released it.
    Check check();
    /// Takes the lock from the other window, which notices with its next check.
    /// Errors   FileNotWritable, DiskFull
    Result<void> takeOver();
    /// Releases the lock: the window shows another project. Later saves do nothing and report OpenElsewhere.
    void close();

private:
    QString path_;
    std::mutex mutex_;
    ProjectLock lock_;
    std::optional<QList<QByteArray>> known_;  ///< contents that may be replaced; nothing: any
    std::optional<std::uint64_t> savedRevision_;
    bool closed_ = false;
};

}  // namespace tiller::project
