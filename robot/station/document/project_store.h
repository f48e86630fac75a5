// SPDX-License-Identifier: MIT
#pragma once

// The file behind the open project: which one it is, whether everything is in it, and saving by itself a
// moment after every change. The file can be open in other windows, and other programs can change it: the store never
// replaces content that it has not read, and keeps a copy of all work that is in no file.

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>
#include <memory>

#include "robot/project/kept_copies.h"
#include "robot/project/project_access.h"
#include "robot/project/project_file.h"
#include "robot/station/executor/serial_executor.h"

namespace tiller {

class ProjectDocument;

class ProjectStore : public QObject {
    Q_OBJECT

public:
    /// Why changes are not saved to the file.
    enum class Obstacle {
        None,
        OpenElsewhere,   ///< another window has the project open
        ChangedByOther,  ///< another program changed the file, and the operator has not decided yet
    };

    explicit ProjectStore(ProjectDocument& document, QObject* parent = nullptr);
    /// Saves what is not saved yet, or keeps a copy of it.
    ~ProjectStore() override;

    /// Where copies of unsaved work are kept; nowhere until this is called.
    void setCopyFolder(const QString& folder);
    const QString& copyFolder() const { return copyFolder_; }

    QString path() const { return path_; }
    bool isModified() const { return modified_; }
    /// Whether every change is in the file.
    bool isSaved() const { return !modified_ && !path_.isEmpty(); }
    /// Of a project that was opened as a copy and has no file yet; empty otherwise.
    QString copyName() const { return copyName_; }
    Obstacle obstacle() const { return obstacle_; }
    /// The other window that has the project open.
    const std::optional<project::LockOwner>& otherOwner() const { return owner_; }
    /// What the project is called: the file's name, or that of the copy.
    QString name() const;
    /// For the status line: "cell-7.tiller — saved", "cell-7.tiller — not saved: disk full".
    QString statusText() const;

    /// Opens the file's project and saves to it from now on. On an error everything stays as it was.
    Result<void> open(const QString& path);
    /// What can be read of a damaged file is shown; the first save puts the damaged one aside.
    Result<project::RecoveredProject> openRecovered(const QString& path);
    /// Shows what is in the file as a project without a file: nothing is saved before saveAs().
    /// name  what the copy is called until then
    Result<void> openCopy(const QString& path, const QString& name);
    /// Shows work that a window left behind unsaved, as a copy with changes.
    Result<void> openKept(const project::KeptCopy& copy);
    /// Saves to this file now and from now on.
    Result<void> saveAs(const QString& path);
    /// As open(); where there is no such file yet, an empty project that will be saved there. For the start
    /// of the program.
    Result<void> openOrStart(const QString& path);
    Result<void> saveNow();
    /// The operator does not want the unsaved changes: no copy of them is kept.
    void discardChanges();

    /// Reads the file again, which another program has changed. Unsaved changes here are lost.
    Result<void> reload();
    /// Takes the project over from the other window, and reads what that one has saved if nothing was changed here.
    Result<void> takeOver();
    /// Saves to a new file beside the one another program has changed, and to that file from now on.
    /// Returns  its path
    Result<QString> keepBoth();
    /// Looks whether another window or program has taken or changed the file. The answer comes as a signal.
    void checkFile();

    /// How long after the last change [ms].
    static constexpr int kAutosaveMs = 400;
    /// How long after a save that failed it is tried again [ms].
    static constexpr int kRetryMs = 5000;

Q_SIGNALS:
    void statusChanged(const QString& text);
    /// Another file is behind the project; none (empty) is behind a copy.
    void pathChanged(const QString& path);
    /// A damaged file was put aside as `copy`.
    void keptAside(const QString& copy);
    /// Saving by itself did not work.
    void saveFailed(const tiller::Error& error);
    /// Saving works again.
    void saveRecovered();
    /// Another window has the project open; changes here are not saved.
    void openElsewhere();
    /// The other window has closed the project; changes here are saved.
    void freeAgain();
    /// Another program has changed the file.
    void changedByOther();
    /// The file holds what this window has read or written again.
    void foreignChangeGone();

private:
    using Access = std::shared_ptr<project::ProjectAccess>;
    void onChange();
    void autosave();
    project::Project snapshot() const;
    void settle(std::uint64_t revision, const Result<project::ProjectAccess::SaveResult>& saved);
    /// The project has just been saved to this file, and is from now on.
    void continueIn(const QString& path, Access access,
                    const Result<project::ProjectAccess::SaveResult>& saved);
    void settleCheck(const project::ProjectAccess::Check& check);
    /// What is open now shall not lose its last changes.
    Result<void> saveLast();
    Result<void> keepCopy();
    /// As reload(), but the copy that was kept of unsaved changes remains.
    Result<void> readAgain();
    void show(const project::Project& project, const QString& path, Access access,
              const QString& copyName = {});
    void useAccess(Access access);
    bool isOpen(const QString& path) const;
    void watch();
    Error obstacleError() const;
    bool showOwnersSave();

    ProjectDocument& document_;
    QString path_;
    QString copyName_;
    QString copyFolder_;
    QTimer autosave_;
    QTimer check_;  ///< a moment after the folder changed
    QFileSystemWatcher watcher_;
    Error lastError_;
    bool modified_ = false;
    bool loading_ = false;
    Obstacle obstacle_ = Obstacle::None;
    std::optional<project::LockOwner> owner_;
    std::optional<QByteArray> announced_;  ///< the foreign content that was reported
    std::uint64_t revision_ = 0;           ///< of the document, for saves that complete late
    Access access_;                        ///< null without a file
    std::shared_ptr<project::CopyKeeper> keeper_;
    SerialExecutor worker_;  ///< where saving by itself waits for the disk
};

}  // namespace tiller
