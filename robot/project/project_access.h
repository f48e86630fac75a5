// SPDX-License-Identifier: MIT
#pragma once

// Access of one window to a project file that other windows, computers and programs can open and change. The
// object holds the lock, records which content this window has read or written, and never replaces any other
// content.

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
        ChangedByOther,  ///< not saved: the file has content that this window has not read
    };
    struct SaveResult {
        Outcome outcome = Outcome::Saved;
        QString keptCopy;  ///< file name under which a damaged project was kept; empty: none
    };
    struct Check {
        std::optional<LockOwner> owner;  ///< the other window that has the project open
        bool changedByOther = false;     ///< the file has content that this window has not read
        QByteArray fingerprint;          ///< fingerprint of the current file; empty if missing or unreadable
    };

    /// path  project file, which need not exist. The constructor does not access it
    explicit ProjectAccess(const QString& path);

    // Threads of all calls: any. Blocks: for the file system, and for other calls of the same object.
    // Real-time: no

    /// Takes the lock if it is free, and reads the file. A later save is refused if the file no longer has
    /// this content.
    /// replaced  revision of the document that the content replaces. Pending saves of this and older
    ///           revisions are skipped.
    /// Errors    as for loadProject()
    Result<Project> load(std::optional<std::uint64_t> replaced = std::nullopt);
    /// Like load(), for a damaged file.
    /// Errors   as for recoverProject()
    Result<RecoveredProject> recover();
    /// Takes the lock for a new file. The first save requires that the file does not exist.
    void start();
    /// Takes the lock for a file that the user agreed to replace.
    void replaceAny();
    /// Writes the project unless another window holds the lock or another program has changed the file.
    /// revision  increases with every change of the document; revisions older than the last save are skipped
    /// Errors    as for saveProject()
    Result<SaveResult> save(const Project& project, std::uint64_t revision);
    /// Checks whether saving is possible. Takes the lock if its owner has released it.
    Check check();
    /// Takes the lock from the other window, which detects the loss with its next check().
    /// Errors   FileNotWritable, DiskFull
    Result<void> takeOver();
    /// Releases the lock when the window shows another project. Later saves have no effect and return
    /// OpenElsewhere.
    void close();

private:
    QString path_;
    std::mutex mutex_;
    ProjectLock lock_;
    std::optional<QList<QByteArray>> known_;  ///< contents that may be replaced; empty: any
    std::optional<std::uint64_t> savedRevision_;
    bool closed_ = false;
};

}  // namespace tiller::project
