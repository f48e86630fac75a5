// SPDX-License-Identifier: MIT
#include "robot/project/kept_copies.h"

#include <QDir>
#include <QFile>
#include <QUuid>
#include <algorithm>

namespace tiller::project {
namespace {

/// Additional field of the project file in kept copies.
constexpr char kField[] = "keptCopy";

}  // namespace

CopyKeeper::CopyKeeper(const QString& folder) : folder_(folder) {}

void CopyKeeper::adopt(const KeptCopy& copy) {
    const std::lock_guard guard(mutex_);
    lock_.emplace(copy.file);
    if (lock_->acquire()) {
        lock_.reset();
        return;
    }
    file_ = copy.file;
}

Result<void> CopyKeeper::keep(const Project& project, const QString& name, std::uint64_t revision) {
    const std::lock_guard guard(mutex_);
    if (folder_.isEmpty() || (revision_ && (*revision_ > revision || (removed_ && *revision_ == revision)))) {
        return {};
    }
    revision_ = revision;
    removed_ = false;
    if (file_.isEmpty()) {
        QDir().mkpath(folder_);
        file_ = QDir(folder_).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) +
                                       QStringLiteral(".tiller"));
        // Lock before the file exists, because other windows must not offer it while this window is open.
        lock_.emplace(file_);
        (void)lock_->acquire();
    }
    Project kept = project;
    kept.extra.insert(
        QLatin1String(kField),
        QJsonObject{{QStringLiteral("name"), name},
                    {QStringLiteral("at"), QDateTime::currentDateTimeUtc().toString(Qt::ISODate)}});
    const Result<SaveReport> saved = saveProject(file_, kept);
    return saved ? Result<void>() : Result<void>(saved.error());
}

void CopyKeeper::remove(std::uint64_t revision) {
    const std::lock_guard guard(mutex_);
    if (revision_ && *revision_ > revision) {
        return;
    }
    revision_ = revision;
    removed_ = true;
    if (!file_.isEmpty()) {
        QFile::remove(file_);
        lock_.reset();
        file_.clear();
    }
}

QList<KeptCopy> keptCopies(const QString& folder) {
    QList<KeptCopy> found;
    const QFileInfoList files = QDir(folder).entryInfoList({QStringLiteral("*.tiller")}, QDir::Files);
    for (const QFileInfo& file : files) {
        ProjectLock lock(file.filePath());
        if (lock.acquire()) {
            continue;  // the window of this copy is still open
        }
        const Result<Project> project = loadProject(file.filePath());
        const QJsonObject about =
            project ? project->extra.value(QLatin1String(kField)).toObject() : QJsonObject();
        if (!about.isEmpty()) {
            found.append({file.filePath(), about.value(QLatin1String("name")).toString(),
                          QDateTime::fromString(about.value(QLatin1String("at")).toString(), Qt::ISODate)});
        }
    }
    std::sort(found.begin(), found.end(), [](const KeptCopy& a, const KeptCopy& b) { return a.at > b.at; });
    return found;
}

Result<Project> loadKeptCopy(const KeptCopy& copy) {
    Result<Project> project = loadProject(copy.file);
    if (project) {
        project->extra.remove(QLatin1String(kField));
    }
    return project;
}

}  // namespace tiller::project
