// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/project/project_store.h"

#include <QFileInfo>
#include <mutex>

#include "widgets/project/project_document.h"

namespace tiller {

struct ProjectStore::Written {
    std::mutex mutex;  ///< held while a file is written
    std::uint64_t revision = 0;
    QString path;
};

ProjectStore::ProjectStore(ProjectDocument& document, QObject* parent)
    : QObject(parent), document_(document), written_(std::make_shared<Written>()) {
    autosave_.setSingleShot(true);
    autosave_.setInterval(kAutosaveMs);
    connect(&autosave_, &QTimer::timeout, this, &ProjectStore::autosave);
    connect(&document_, &ProjectDocument::documentChanged, this, &ProjectStore::onChange);
}

ProjectStore::~ProjectStore() {
    if (modified_ && !path_.isEmpty()) {
        (void)saveNow();
    }
}

QString ProjectStore::statusText() const {
    if (!copyName_.isEmpty()) {
        return tr("%1 — a copy, not saved to a file").arg(copyName_);
    }
    if (path_.isEmpty()) {
        return modified_ ? tr("project not saved to a file") : QString();
    }
    const QString name = QFileInfo(path_).fileName();
    if (lastError_.code != ErrorCode::None) {
        const QString why = lastError_.code == ErrorCode::DiskFull   ? tr("disk full")
                            : lastError_.controllerMessage.isEmpty() ? lastError_.context
                                                                     : lastError_.controllerMessage;
        return tr("%1 — not saved: %2").arg(name, why);
    }
    return modified_ ? tr("%1 — saving…").arg(name) : tr("%1 — saved").arg(name);
}

void ProjectStore::onChange() {
    if (loading_) {
        return;
    }
    modified_ = true;
    ++revision_;
    if (!path_.isEmpty()) {
        autosave_.start();
    }
    Q_EMIT statusChanged(statusText());
}

void ProjectStore::show(const project::Project& project, const QString& path, const QString& copyName) {
    autosave_.stop();
    loading_ = true;
    document_.setProject(project);
    loading_ = false;
    path_ = path;
    copyName_ = copyName;
    modified_ = false;
    lastError_ = {};
    Q_EMIT statusChanged(statusText());
    Q_EMIT pathChanged(path_);
}

Result<void> ProjectStore::open(const QString& path) {
    const Result<project::Project> loaded = project::loadProject(path);
    if (!loaded) {
        return loaded.error();
    }
    if (const Result<void> saved = saveLast(); !saved) {
        return saved;
    }
    show(*loaded, path);
    return {};
}

Result<void> ProjectStore::openCopy(const QString& path, const QString& name) {
    const Result<project::Project> loaded = project::loadProject(path);
    if (!loaded) {
        return loaded.error();
    }
    if (const Result<void> saved = saveLast(); !saved) {
        return saved;
    }
    show(*loaded, {}, name);
    return {};
}

Result<void> ProjectStore::saveLast() {
    return modified_ && !path_.isEmpty() ? saveNow() : Result<void>();
}

Result<project::RecoveredProject> ProjectStore::openRecovered(const QString& path) {
    Result<project::RecoveredProject> recovered = project::recoverProject(path);
    if (recovered) {
        if (const Result<void> saved = saveLast(); !saved) {
            return saved.error();
        }
        show(recovered->document, path);
        // Not saved until something is done with it: the damaged file is still the only whole one.
        modified_ = true;
        Q_EMIT statusChanged(statusText());
    }
    return recovered;
}

Result<void> ProjectStore::saveAs(const QString& path) {
    const QString before = path_;
    path_ = path;
    Result<void> saved = saveNow();
    if (!saved) {
        path_ = before;
        Q_EMIT statusChanged(statusText());
    } else if (path_ != before) {
        copyName_.clear();
        Q_EMIT statusChanged(statusText());
        Q_EMIT pathChanged(path_);
    }
    return saved;
}

Result<void> ProjectStore::openOrStart(const QString& path) {
    if (QFileInfo::exists(path)) {
        return open(path);
    }
    show({}, path);
    return {};
}

project::Project ProjectStore::snapshot() const {
    return document_.project();
}

void ProjectStore::autosave() {
    // The disk may take its time: not in the thread that paints, and that stops the arm.
    worker_.post(this, [this, path = path_, revision = revision_, project = snapshot(),
                        written = written_](const CancelToken&) {
        const std::lock_guard lock(written->mutex);
        if (written->path == path && written->revision >= revision) {
            return std::function<void()>();  // saved by hand meanwhile
        }
        const Result<project::SaveReport> saved = project::saveProject(path, project);
        if (saved) {
            written->path = path;
            written->revision = revision;
        }
        return std::function<void()>([this, path, revision, saved] {
            if (path != path_) {
                return;  // another file was opened meanwhile
            }
            settle(revision, saved);
            if (!saved) {
                Q_EMIT saveFailed(saved.error());
            }
        });
    });
}

void ProjectStore::settle(std::uint64_t revision, const Result<project::SaveReport>& saved) {
    lastError_ = saved.error();
    if (saved) {
        modified_ = modified_ && revision != revision_;
        if (!saved->keptCopy.isEmpty()) {
            Q_EMIT keptAside(saved->keptCopy);
        }
    }
    Q_EMIT statusChanged(statusText());
}

Result<void> ProjectStore::saveNow() {
    autosave_.stop();
    if (path_.isEmpty()) {
        return Error{ErrorCode::FileNotWritable, tr("no file chosen"), {}};
    }
    const std::lock_guard lock(written_->mutex);
    const Result<project::SaveReport> saved = project::saveProject(path_, snapshot());
    if (saved) {
        written_->path = path_;
        written_->revision = revision_;
    }
    settle(revision_, saved);
    return saved ? Result<void>() : Result<void>(saved.error());
}

}  // namespace tiller

#include "moc_project_store.cpp"
