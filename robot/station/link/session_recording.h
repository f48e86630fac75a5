// SPDX-License-Identifier: MIT
#pragma once

// Records robot data in a file, with one row per packet or per n-th packet. No call blocks.
// SessionState::recording and messages show the results.

#include <QByteArray>
#include <QCoreApplication>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "robot/receive/receiver.h"
#include "robot/recording/recorder.h"
#include "robot/station/link/recording_choice.h"

namespace tiller {

class RobotSession;
enum class Severity;
struct SessionBackend;

/// Settings of a new recording.
struct RecordingOrder {
    QString path;
    QStringList fields{};  ///< RTDE names; empty: the fields that ur_rtde records or, in a complete format,
                           ///< all fields
    QStringList shown{};   ///< RTDE names of displayed signals, recorded additionally
    int every = 1;         ///< every n-th packet becomes a row
    QString format = QStringLiteral("csv");  ///< see RecordingChoice::format
    std::int64_t keepFree = 200'000'000;     ///< minimum free disk space; recording stops below it [bytes]
    recording::Metadata metadata{};          ///< entries of the user; in CSV files, written above the header
    /// As RecordingChoice::trigger. The fields of the trigger are recorded additionally.
    QString trigger{};
    double before = 0;           ///< recorded time before the trigger [s]
    double after = 0;            ///< recorded time after the trigger [s]
    double fileSeconds = 0;      ///< see RecorderOptions::fileSeconds
    std::int64_t fileBytes = 0;  ///< see RecorderOptions::fileBytes
};

class SessionRecording {
    Q_DECLARE_TR_FUNCTIONS(SessionRecording)

public:
    SessionRecording(RobotSession& session, SessionBackend& backend);

    void start(const RecordingOrder& order);
    void start(const QString& path, const QStringList& fields = {}) {
        start(RecordingOrder{.path = path, .fields = fields});
    }
    /// Sets the project stored in files of formats that support it, starting with the next recording. Empty
    /// name: no project is stored.
    void setProject(const QString& name, const QByteArray& content);
    void stop();
    /// Reports displayed signals that the current recording does not contain, each once.
    /// fields  RTDE names
    void reportDisplayed(const QStringList& fields);

    // Called by the session.
    void reportFailure();

private:
    /// Adds an entry to the current recording, if there is one.
    void keep(const recording::RecordedNote& note);
    QString recordedText(const recording::RecorderProgress& progress) const;
    /// Reports why a recording cannot start. The state shows the reason until the next attempt.
    void refuse(Severity severity, const QString& why);
    /// The receiver of the link, or another receiver if the link does not receive all fields.
    std::shared_ptr<receive::Receiver> receiverFor(const std::vector<std::string>& fields);

    RobotSession& session_;
    SessionBackend& d_;
    bool wasRecording_ = false;
    bool reportedNotes_ = false;  ///< a failure to write notes was reported
    QStringList contained_;       ///< RTDE names recorded or already reported as missing
    QString projectName_;
    QByteArray project_;
};

}  // namespace tiller
