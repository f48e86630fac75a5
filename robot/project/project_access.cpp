// SPDX-License-Identifier: MIT
#include "robot/project/project_access.h"

#include <QFileInfo>

#include "robot/core/file_reading.h"

namespace tiller::project {

ProjectAccess::ProjectAccess(const QString& path) : path_(path), lock_(path) {}

Result<Project> ProjectAccess::load(std::optional<std::uint64_t> replaced) {
    const std::lock_guard guard(mutex_);
    // Lock before reading, because the previous owner may still be writing.
    (void)lock_.acquire();
    Result<OpenedProject> opened = openProject(path_);
    if (!opened) {
        return opened.error();
    }
    known_ = {opened->fingerprint};
    savedRevision_ = replaced;
    return std::move(opened->document);
}

Result<RecoveredProject> ProjectAccess::recover() {
    const std::lock_guard guard(mutex_);
    (void)lock_.acquire();
    Result<RecoveredProject> recovered = recoverProject(path_);
    if (recovered) {
        known_ = {recovered->fingerprint};
        savedRevision_.reset();
    }
    return recovered;
}

void ProjectAccess::start() {
    const std::lock_guard guard(mutex_);
    (void)lock_.acquire();
    known_ = QList<QByteArray>();
}

void ProjectAccess::replaceAny() {
    const std::lock_guard guard(mutex_);
    (void)lock_.acquire();
    known_.reset();
}

Result<ProjectAccess::SaveResult> ProjectAccess::save(const Project& project, std::uint64_t revision) {
    const std::lock_guard guard(mutex_);
    if (savedRevision_ && *savedRevision_ >= revision) {
        return SaveResult{};
    }
    if (closed_ || lock_.acquire()) {
        return SaveResult{Outcome::OpenElsewhere, {}};
    }
    const Result<SaveReport> report = saveProject(path_, project, known_);
    if (!report) {
        // If only flushing the folder failed, the file may already have the new content.
        if (const Result<QByteArray> bytes = serializeProject(project); bytes && known_) {
            known_->append(fingerprintOf(*bytes));
        }
        return report.error();
    }
    if (report->changedByOther) {
        return SaveResult{Outcome::ChangedByOther, {}};
    }
    known_ = {report->fingerprint};
    savedRevision_ = revision;
    return SaveResult{Outcome::Saved, report->keptCopy};
}

ProjectAccess::Check ProjectAccess::check() {
    const std::lock_guard guard(mutex_);
    Check check;
    check.owner = lock_.acquire();
    if (QFileInfo::exists(path_)) {
        if (const Result<QByteArray> there = readWholeFile(path_, kMaxProjectFileBytes)) {
            check.fingerprint = fingerprintOf(*there);
        }
        check.changedByOther = known_ && !known_->contains(check.fingerprint);
    }
    return check;
}

Result<void> ProjectAccess::takeOver() {
    const std::lock_guard guard(mutex_);
    return lock_.takeOver();
}

void ProjectAccess::close() {
    const std::lock_guard guard(mutex_);
    lock_.release();
    closed_ = true;
}

}  // namespace tiller::project
