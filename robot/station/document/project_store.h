// SPDX-License-Identifier: MIT
#pragma once

// The file of the open project: path, save state, and automatic saving shortly after every change. Other
// windows can open the file, and other programs can change it. The store never overwrites content that it has
// not read, and keeps a copy of all work that is not saved in a file.

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>
#include <functional>
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
        ChangedByOther,  ///< changed by another program; waiting for the operator's decision
    };

    explicit ProjectStore(ProjectDocument& document, QObject* parent = nullptr);
    /// Saves unsaved changes, or keeps a copy of them.
    ~ProjectStore() override;

    /// Sets the folder for copies of unsaved work. Empty: no copies are kept.
    void setCopyFolder(const QString& folder);
    const QString& copyFolder() const { return copyFolder_; }

    QString path() const { return path_; }
    bool isModified() const { return modified_; }
    /// True if all changes are saved in the file.
    bool isSaved() const { return !modified_ && !path_.isEmpty(); }
    /// Name of a project that was opened as a copy and has no file yet; empty otherwise.
    QString copyName() const { return copyName_; }
    Obstacle obstacle() const { return obstacle_; }
    const std::optional<project::LockOwner>& otherOwner() const { return owner_; }
    /// Name of the project: that of its file or, for a copy, copyName().
    QString name() const;
    /// Text for the status bar, e.g. "cell-7.tiller — saved", "cell-7.tiller — not saved: disk full".
    QString statusText() const;

    /// guard  returns why the project must not be replaced now, as a sentence; empty if it may be replaced.
    ///        Every function that would replace the content then fails with Cancelled and this sentence.
    void setReplaceGuard(std::function<QString()> guard) { replaceGuard_ = std::move(guard); }
    Result<void> mayReplace() const;

    /// Opens the project file. Later changes are saved to this file. After an error, the state is unchanged.
    Result<void> open(const QString& path);
    /// Opens the readable part of a damaged file. The first save renames the damaged file.
    Result<project::RecoveredProject> openRecovered(const QString& path);
    /// Opens the content of the file as a project without a file. Nothing is saved before saveAs().
    /// name  name of the copy until saveAs()
    Result<void> openCopy(const QString& path, const QString& name);
    /// Opens unsaved work of an earlier window as a modified copy.
    Result<void> openKept(const project::KeptCopy& copy);
    /// Saves to this file. Later changes are also saved to this file.
    Result<void> saveAs(const QString& path);
    /// Like open(), but creates an empty project if the file does not exist. Called at program start.
    Result<void> openOrStart(const QString& path);
    Result<void> saveNow();
    /// Discards the unsaved changes at the operator's request, without keeping a copy.
    void discardChanges();

    /// Reads the file again after another program has changed it. Unsaved changes are kept as a copy, or lost
    /// without a copy folder.
    Result<void> reload();
    /// Takes over the project from the other window. Without changes in this window, reads the last state
    /// saved by the other window.
    Result<void> takeOver();
    /// Saves to a new file next to the file that another program has changed. Later changes are saved to the
    /// new file.
    /// Returns  the path of the new file
    Result<QString> keepBoth();
    /// Checks whether another window or program has locked or changed the file. A signal reports the result.
    void checkFile();

    /// Delay of the automatic save after the last change [ms].
    static constexpr int kAutosaveMs = 400;
    /// Delay before a failed save is retried [ms].
    static constexpr int kRetryMs = 5000;

Q_SIGNALS:
    void statusChanged(const QString& text);
    /// The path of the project file has changed. `path` is empty for a copy.
    void pathChanged(const QString& path);
    /// A damaged file was renamed to `copy`.
    void copyKept(const QString& copy);
    void saveFailed(const tiller::Error& error);
    void saveRecovered();
    /// Another window has the project open, so changes in this window are not saved.
    void openElsewhere();
    /// This window saves again, because the other window has closed the project or lost it to takeOver().
    void freeAgain();
    void changedByOther();
    /// The file again has the content that this window last read or wrote.
    void externalChangeResolved();

private:
    using Access = std::shared_ptr<project::ProjectAccess>;
    void onChange();
    void autosave();
    project::Project snapshot() const;
    void settle(std::uint64_t revision, const Result<project::ProjectAccess::SaveResult>& saved);
    /// Continues with this file, to which the project has just been saved.
    void continueIn(const QString& path, Access access,
                    const Result<project::ProjectAccess::SaveResult>& saved);
    void settleCheck(const project::ProjectAccess::Check& check);
    /// Saves the last changes of the open project, or keeps a copy, before the project is replaced.
    Result<void> saveLast();
    Result<void> keepCopy();
    /// Like reload(), but keeps an existing copy of unsaved changes.
    Result<void> readAgain();
    void show(const project::Project& project, const QString& path, Access access,
              const QString& copyName = {});
    void useAccess(Access access);
    bool isOpen(const QString& path) const;
    void watch();
    static QString openElsewhereText(const QString& path, const std::optional<project::LockOwner>& owner);
    Error obstacleError() const;
    bool showOwnersSave();

    ProjectDocument& document_;
    QString path_;
    QString copyName_;
    QString copyFolder_;
    QTimer autosave_;
    QTimer check_;  ///< started by a change in the folder
    QFileSystemWatcher watcher_;
    Error lastError_;
    bool modified_ = false;
    bool loading_ = false;
    Obstacle obstacle_ = Obstacle::None;
    std::optional<project::LockOwner> owner_;
    std::optional<QByteArray> announced_;  ///< fingerprint of the last reported content of another program
    std::uint64_t revision_ = 0;           ///< document revision; detects saves that complete too late
    Access access_;                        ///< null without a file
    std::shared_ptr<project::CopyKeeper> keeper_;
    std::function<QString()> replaceGuard_ = [] { return QString(); };
    SerialExecutor worker_;  ///< runs automatic saves
};

}  // namespace tiller
