// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The file behind the open project: which one it is, whether everything is in it, and saving by itself a
// moment after every change.

#include <QObject>
#include <QTimer>
#include <memory>

#include "robot/project/project_file.h"
#include "widgets/session/session_worker.h"

namespace tiller {

class ProjectDocument;

class ProjectStore : public QObject {
    Q_OBJECT

public:
    explicit ProjectStore(ProjectDocument& document, QObject* parent = nullptr);
    /// Saves what is not saved yet, if there is a file.
    ~ProjectStore() override;

    QString path() const { return path_; }
    bool isModified() const { return modified_; }
    /// Of a project that was opened as a copy and has no file yet; empty otherwise.
    QString copyName() const { return copyName_; }
    /// A copy with changes, which nothing saves by itself.
    bool isUnsavedCopy() const { return modified_ && !copyName_.isEmpty(); }
    /// For the status line: "cell-7.tiller — saved", "cell-7.tiller — not saved: disk full".
    QString statusText() const;

    /// Opens the file's project and saves to it from now on. On an error everything stays as it was.
    Result<void> open(const QString& path);
    /// What can be read of a damaged file is shown; the first save puts the damaged one aside.
    Result<project::RecoveredProject> openRecovered(const QString& path);
    /// Shows what is in the file as a project without a file: nothing is saved before saveAs().
    /// name  what the copy is called until then
    Result<void> openCopy(const QString& path, const QString& name);
    /// Saves to this file now and from now on.
    Result<void> saveAs(const QString& path);
    /// As open(); where there is no such file yet, an empty project that will be saved there. For the start
    /// of the program.
    Result<void> openOrStart(const QString& path);
    Result<void> saveNow();

    /// How long after the last change [ms].
    static constexpr int kAutosaveMs = 400;

Q_SIGNALS:
    void statusChanged(const QString& text);
    /// Another file is behind the project; none (empty) is behind a copy.
    void pathChanged(const QString& path);
    /// A damaged file was put aside as `copy`.
    void keptAside(const QString& copy);
    /// Saving by itself did not work.
    void saveFailed(const tiller::Error& error);

private:
    void onChange();
    void autosave();
    project::Project snapshot() const;
    void settle(std::uint64_t revision, const Result<project::SaveReport>& saved);
    /// What is open now shall not lose its last changes, if it has a file.
    Result<void> saveLast();
    void show(const project::Project& project, const QString& path, const QString& copyName = {});

    ProjectDocument& document_;
    QString path_;
    QString copyName_;
    QTimer autosave_;
    Error lastError_;
    bool modified_ = false;
    bool loading_ = false;
    std::uint64_t revision_ = 0;  ///< of the document, for saves that come home late
    /// Between the window and the worker: the newest revision that is in the file, so that a slow save never
    /// overwrites a later one.
    struct Written;
    std::shared_ptr<Written> written_;
    SessionWorker worker_;  ///< where saving by itself waits for the disk
};

}  // namespace tiller
