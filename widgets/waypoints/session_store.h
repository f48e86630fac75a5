// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The file behind the waypoints: which one it is, whether everything is in it, and saving by itself a moment
// after every change.

#include <QObject>
#include <QTimer>

#include "robot/program/session_file.h"

namespace tiller {

class WaypointModel;

class SessionStore : public QObject {
    Q_OBJECT

public:
    explicit SessionStore(WaypointModel& model, QObject* parent = nullptr);
    /// Saves what is not saved yet, if there is a file.
    ~SessionStore() override;

    QString path() const { return path_; }
    bool isModified() const { return modified_; }
    /// For the status line: "cell-7.tiller — saved", "cell-7.tiller — not saved: disk full".
    QString statusText() const;

    /// Shows the file's waypoints and saves to it from now on. On an error everything stays as it was.
    Result<void> open(const QString& path);
    /// What can be read of a damaged file is shown; the first save puts the damaged one aside.
    Result<program::RecoveredSession> openRecovered(const QString& path);
    /// Saves to this file now and from now on.
    Result<void> saveAs(const QString& path);
    /// As open(); where there is no such file yet, an empty list that will be saved there. For the start of
    /// the program.
    Result<void> openOrStart(const QString& path);
    Result<void> saveNow();

    /// How long after the last change [ms].
    static constexpr int kAutosaveMs = 400;

Q_SIGNALS:
    void statusChanged(const QString& text);
    /// A damaged file was put aside as `copy`.
    void keptAside(const QString& copy);
    /// Saving by itself did not work.
    void saveFailed(const tiller::Error& error);

private:
    void onChange();
    void show(const program::SessionDocument& document, const QString& path);

    WaypointModel& model_;
    QString path_;
    QTimer autosave_;
    Error lastError_;
    bool modified_ = false;
    bool loading_ = false;
};

}  // namespace tiller
