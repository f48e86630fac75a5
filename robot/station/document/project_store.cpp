// SPDX-License-Identifier: MIT
#include "robot/station/document/project_store.h"

#include <QDir>
#include <QFileInfo>
#include <utility>

#include "robot/station/document/project_document.h"

namespace tiller {
namespace {

constexpr int kCheckDelayMs = 150;

using Outcome = project::ProjectAccess::Outcome;

}  // namespace

ProjectStore::ProjectStore(ProjectDocument& document, QObject* parent)
    : QObject(parent), document_(document), keeper_(std::make_shared<project::CopyKeeper>(QString())) {
    autosave_.setSingleShot(true);
    check_.setSingleShot(true);
    check_.setInterval(kCheckDelayMs);
    connect(&autosave_, &QTimer::timeout, this, &ProjectStore::autosave);
    connect(&check_, &QTimer::timeout, this, &ProjectStore::checkFile);
    connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, [this] { check_.start(); });
    connect(&watcher_, &QFileSystemWatcher::fileChanged, this, [this] { check_.start(); });
    connect(&document_, &ProjectDocument::documentChanged, this, &ProjectStore::onChange);
}

ProjectStore::~ProjectStore() {
    (void)saveLast();
}

void ProjectStore::setCopyFolder(const QString& folder) {
    copyFolder_ = folder;
    keeper_ = std::make_shared<project::CopyKeeper>(folder);
}

QString ProjectStore::name() const {
    return copyName_.isEmpty() ? QFileInfo(path_).fileName() : copyName_;
}

QString ProjectStore::statusText() const {
    if (!copyName_.isEmpty()) {
        return tr("%1 — a copy, not saved to a file").arg(copyName_);
    }
    if (path_.isEmpty()) {
        return modified_ ? tr("Project not saved to a file") : QString();
    }
    if (obstacle_ == Obstacle::OpenElsewhere) {
        return tr("%1 — open in another window; changes here are not saved").arg(name());
    }
    if (obstacle_ == Obstacle::ChangedByOther) {
        return tr("%1 — changed by another program; changes here are not saved").arg(name());
    }
    if (lastError_.code != ErrorCode::None) {
        const QString why = lastError_.code == ErrorCode::DiskFull   ? tr("disk full")
                            : lastError_.controllerMessage.isEmpty() ? lastError_.context
                                                                     : lastError_.controllerMessage;
        return tr("%1 — not saved: %2").arg(name(), why);
    }
    return modified_                   ? tr("%1 — saving…").arg(name())
           : !QFileInfo::exists(path_) ? tr("%1 — new").arg(name())
                                       : tr("%1 — saved").arg(name());
}

void ProjectStore::onChange() {
    if (loading_) {
        return;
    }
    modified_ = true;
    ++revision_;
    // Frequent changes must not postpone the save indefinitely.
    if (!autosave_.isActive() || autosave_.remainingTime() > kAutosaveMs) {
        autosave_.start(kAutosaveMs);
    }
    Q_EMIT statusChanged(statusText());
}

void ProjectStore::show(const project::Project& project, const QString& path, Access access,
                        const QString& copyName) {
    autosave_.stop();
    loading_ = true;
    document_.setProject(project);
    loading_ = false;
    path_ = path;
    useAccess(std::move(access));
    copyName_ = copyName;
    modified_ = false;
    ++revision_;
    lastError_ = {};
    announced_.reset();
    owner_.reset();
    obstacle_ = Obstacle::None;
    keeper_ = std::make_shared<project::CopyKeeper>(copyFolder_);
    watch();
    Q_EMIT statusChanged(statusText());
    Q_EMIT pathChanged(path_);
    if (access_ != nullptr) {
        settleCheck(access_->check());
    }
}

void ProjectStore::useAccess(Access access) {
    if (access_ != nullptr && access_ != access) {
        access_->close();
    }
    access_ = std::move(access);
}

void ProjectStore::watch() {
    if (const QStringList before = watcher_.files() + watcher_.directories(); !before.isEmpty()) {
        watcher_.removePaths(before);
    }
    if (!path_.isEmpty()) {
        // Watching the folder detects replaced files. Watching the file detects in-place writes.
        watcher_.addPath(QFileInfo(path_).absolutePath());
        if (QFileInfo::exists(path_)) {
            watcher_.addPath(path_);
        }
    }
}

bool ProjectStore::isOpen(const QString& path) const {
    return !path_.isEmpty() &&
           (path == path_ || (QFileInfo::exists(path) && QFileInfo(path) == QFileInfo(path_)));
}

Result<void> ProjectStore::mayReplace() const {
    const QString reason = replaceGuard_();
    return reason.isEmpty() ? Result<void>() : Error{ErrorCode::Cancelled, reason, {}};
}

Result<void> ProjectStore::open(const QString& path) {
    if (const Result<void> may = mayReplace(); !may) {
        return may.error();
    }
    if (isOpen(path)) {
        // This window already holds the lock of the current project, so read the file again instead of
        // opening it.
        if (const Result<void> saved = saveLast(); !saved) {
            return saved;
        }
        return readAgain();
    }
    auto access = std::make_shared<project::ProjectAccess>(path);
    const Result<project::Project> loaded = access->load();
    if (!loaded) {
        return loaded.error();
    }
    if (const Result<void> saved = saveLast(); !saved) {
        return saved;
    }
    show(*loaded, path, std::move(access));
    return {};
}

Result<void> ProjectStore::openCopy(const QString& path, const QString& name) {
    if (const Result<void> may = mayReplace(); !may) {
        return may.error();
    }
    const Result<project::Project> loaded = project::loadProject(path);
    if (!loaded) {
        return loaded.error();
    }
    if (const Result<void> saved = saveLast(); !saved) {
        return saved;
    }
    show(*loaded, {}, nullptr, name);
    return {};
}

Result<void> ProjectStore::openKept(const project::KeptCopy& copy) {
    if (const Result<void> may = mayReplace(); !may) {
        return may.error();
    }
    const Result<project::Project> loaded = project::loadKeptCopy(copy);
    if (!loaded) {
        return loaded.error();
    }
    if (const Result<void> saved = saveLast(); !saved) {
        return saved;
    }
    show(*loaded, {}, nullptr, copy.name.isEmpty() ? tr("Unsaved project") : copy.name);
    keeper_->adopt(copy);
    modified_ = true;
    autosave_.start(kAutosaveMs);  // write a copy soon, because another window may use the copy on disk
    Q_EMIT statusChanged(statusText());
    return {};
}

Result<void> ProjectStore::saveLast() {
    if (!modified_) {
        return {};
    }
    if (!path_.isEmpty() && obstacle_ == Obstacle::None) {
        const Result<void> saved = saveNow();
        // A copy in the application folder is sufficient, because Tiller offers to restore it at the next
        // start.
        return saved || (!copyFolder_.isEmpty() && keepCopy()) ? Result<void>() : saved;
    }
    return keepCopy();
}

Result<void> ProjectStore::keepCopy() {
    return keeper_->keep(snapshot(), name(), revision_);
}

void ProjectStore::discardChanges() {
    autosave_.stop();
    modified_ = false;
    keeper_->remove(revision_);
    Q_EMIT statusChanged(statusText());
}

Result<project::RecoveredProject> ProjectStore::openRecovered(const QString& path) {
    if (const Result<void> may = mayReplace(); !may) {
        return may.error();
    }
    auto access = std::make_shared<project::ProjectAccess>(path);
    Result<project::RecoveredProject> recovered = access->recover();
    if (recovered) {
        if (const Result<void> saved = saveLast(); !saved) {
            return saved.error();
        }
        show(recovered->document, path, std::move(access));
        // Do not save before the first edit, because the damaged file is still the only complete version.
        modified_ = true;
        Q_EMIT statusChanged(statusText());
    }
    return recovered;
}

Result<void> ProjectStore::saveAs(const QString& path) {
    if (isOpen(path)) {
        return saveNow();
    }
    auto access = std::make_shared<project::ProjectAccess>(path);
    access->replaceAny();
    const auto saved = access->save(snapshot(), revision_);
    if (!saved) {
        return saved.error();
    }
    if (saved->outcome != Outcome::Saved) {
        const auto owner = access->check().owner;
        return Error{ErrorCode::FileNotWritable, openElsewhereText(path, owner), {}};
    }
    continueIn(path, std::move(access), saved);
    return {};
}

QString ProjectStore::openElsewhereText(const QString& path, const std::optional<project::LockOwner>& owner) {
    return tr("%1 is open in another window (%2). Close the project in that window, or save under a "
              "different name.")
        .arg(path, owner ? owner->toString() : tr("another program"));
}

void ProjectStore::continueIn(const QString& path, Access access,
                              const Result<project::ProjectAccess::SaveResult>& saved) {
    autosave_.stop();
    useAccess(std::move(access));
    path_ = path;
    copyName_.clear();
    obstacle_ = Obstacle::None;
    owner_.reset();
    announced_.reset();
    settle(revision_, saved);
    watch();
    Q_EMIT pathChanged(path_);
}

Result<void> ProjectStore::openOrStart(const QString& path) {
    if (const Result<void> may = mayReplace(); !may) {
        return may.error();
    }
    if (QFileInfo::exists(path) || path == path_) {
        return open(path);
    }
    if (const Result<void> saved = saveLast(); !saved) {
        return saved;
    }
    auto access = std::make_shared<project::ProjectAccess>(path);
    access->start();
    show({}, path, std::move(access));
    return {};
}

project::Project ProjectStore::snapshot() const {
    return document_.project();
}

void ProjectStore::autosave() {
    // Disk access may be slow, and the GUI thread must always be able to stop the arm, so the save runs in
    // the worker.
    const Access access = obstacle_ == Obstacle::None ? access_ : nullptr;
    worker_.post(this, [this, access, keeper = keeper_, name = name(), revision = revision_,
                        project = snapshot()](const CancelToken&) {
        if (access == nullptr) {
            (void)keeper->keep(project, name, revision);
            return std::function<void()>();
        }
        const auto saved = access->save(project, revision);
        if (!saved || saved->outcome != Outcome::Saved) {
            (void)keeper->keep(project, name, revision);
        }
        return std::function<void()>([this, access, revision, saved] {
            if (access != access_) {
                return;  // another file has been opened
            }
            const bool failedBefore = lastError_.code != ErrorCode::None;
            settle(revision, saved);
            if (!saved && !failedBefore) {
                Q_EMIT saveFailed(saved.error());
            }
        });
    });
}

void ProjectStore::settle(std::uint64_t revision, const Result<project::ProjectAccess::SaveResult>& saved) {
    const bool failedBefore = lastError_.code != ErrorCode::None;
    lastError_ = saved.error();
    if (!saved) {
        autosave_.start(kRetryMs);
    }
    if (saved && saved->outcome == Outcome::Saved) {
        modified_ = modified_ && revision != revision_;
        keeper_->remove(revision);
        if (!saved->keptCopy.isEmpty()) {
            Q_EMIT copyKept(saved->keptCopy);
        }
        if (failedBefore) {
            Q_EMIT saveRecovered();
        }
        if (!watcher_.files().contains(path_) && QFileInfo::exists(path_)) {
            watcher_.addPath(path_);
        }
    } else if (saved && access_ != nullptr) {
        settleCheck(access_->check());
    }
    Q_EMIT statusChanged(statusText());
}

void ProjectStore::checkFile() {
    if (access_ == nullptr) {
        return;
    }
    worker_.post(this, [this, access = access_](const CancelToken&) {
        const project::ProjectAccess::Check check = access->check();
        return std::function<void()>([this, access, check] {
            if (access == access_) {
                settleCheck(check);
                watch();
            }
        });
    });
}

void ProjectStore::settleCheck(const project::ProjectAccess::Check& check) {
    const Obstacle before = obstacle_;
    owner_ = check.owner;
    obstacle_ = check.owner            ? Obstacle::OpenElsewhere
                : check.changedByOther ? Obstacle::ChangedByOther
                                       : Obstacle::None;
    if (obstacle_ != before) {
        Q_EMIT statusChanged(statusText());
    }
    if (obstacle_ == Obstacle::OpenElsewhere && before != obstacle_) {
        Q_EMIT openElsewhere();
    } else if (before == Obstacle::OpenElsewhere && obstacle_ != before) {
        Q_EMIT freeAgain();
    }
    if (!check.changedByOther) {
        if (std::exchange(announced_, std::nullopt)) {
            Q_EMIT externalChangeResolved();
        }
    } else if (check.owner && !modified_ && showOwnersSave()) {
        return;
    } else if (announced_ != check.fingerprint && !(check.owner && announced_)) {
        announced_ = check.fingerprint;
        Q_EMIT changedByOther();
    }
    if (obstacle_ == Obstacle::None && before != obstacle_ && modified_) {
        autosave_.start(kAutosaveMs);
    }
}

/// In a view-only window, loads each save of the lock owner without asking. If the project must not be
/// replaced now, a later check loads the save.
/// Returns  false if the file could not be read
bool ProjectStore::showOwnersSave() {
    if (!mayReplace()) {
        return true;
    }
    const Result<project::Project> loaded = access_->load(revision_);
    if (!loaded) {
        return false;
    }
    loading_ = true;
    document_.setProject(*loaded);
    loading_ = false;
    ++revision_;
    if (std::exchange(announced_, std::nullopt)) {
        Q_EMIT externalChangeResolved();
    }
    return true;
}

Result<void> ProjectStore::reload() {
    if (const Result<void> may = mayReplace(); !may) {
        return may.error();
    }
    if (access_ == nullptr) {
        return {};
    }
    // Reloading cannot be undone. Keep unsaved changes as a copy, which Tiller offers to restore at the next
    // start.
    if (modified_ && !copyFolder_.isEmpty()) {
        if (const Result<void> kept = keepCopy(); !kept) {
            return kept;
        }
        return readAgain();
    }
    // Keep a reference, because readAgain() replaces keeper_.
    const auto keeper = keeper_;
    const std::uint64_t replaced = revision_;
    const Result<void> read = readAgain();
    if (read) {
        keeper->remove(replaced);
    }
    return read;
}

Result<void> ProjectStore::readAgain() {
    const Result<project::Project> loaded = access_->load(revision_);
    if (!loaded) {
        return loaded.error();
    }
    show(*loaded, path_, access_);
    return {};
}

Result<void> ProjectStore::takeOver() {
    if (const Result<void> may = mayReplace(); !may) {
        return may.error();
    }
    if (access_ == nullptr) {
        return {};
    }
    if (const Result<void> taken = access_->takeOver(); !taken) {
        return taken;
    }
    if (!modified_) {
        return reload();
    }
    settleCheck(access_->check());
    return {};
}

Result<QString> ProjectStore::keepBoth() {
    const QFileInfo file(path_);
    for (int number = 2;; ++number) {
        const QString copy = file.absoluteDir().filePath(
            QStringLiteral("%1-%2.%3").arg(file.completeBaseName()).arg(number).arg(file.suffix()));
        if (QFileInfo::exists(copy)) {
            continue;
        }
        // If another window or program creates a file with this name at the same time, that file is kept.
        auto access = std::make_shared<project::ProjectAccess>(copy);
        access->start();
        const auto saved = access->save(snapshot(), revision_);
        if (!saved) {
            return saved.error();
        }
        if (saved->outcome == Outcome::Saved) {
            continueIn(copy, std::move(access), saved);
            return copy;
        }
    }
}

Error ProjectStore::obstacleError() const {
    return {
        ErrorCode::FileNotWritable,
        obstacle_ == Obstacle::OpenElsewhere
            ? openElsewhereText(path_, owner_)
            : tr("%1 was changed by another program. Reload the project, or save it under a different name.")
                  .arg(path_),
        {}};
}

Result<void> ProjectStore::saveNow() {
    autosave_.stop();
    if (access_ == nullptr) {
        return Error{ErrorCode::FileNotWritable,
                     tr("No file is selected for the project. Save the project to a file first."),
                     {}};
    }
    if (obstacle_ == Obstacle::ChangedByOther) {
        return obstacleError();
    }
    const auto saved = access_->save(snapshot(), revision_);
    settle(revision_, saved);
    if (!saved) {
        return saved.error();
    }
    return saved->outcome == Outcome::Saved ? Result<void>() : Result<void>(obstacleError());
}

}  // namespace tiller

#include "moc_project_store.cpp"
