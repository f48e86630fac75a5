// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One CSV row per packet, or per n packets. Both calls return at once; what became of them shows in SessionState::recording and as a
// message.

#include <QCoreApplication>
#include <QString>
#include <QStringList>

namespace tiller {

class RobotSession;
struct SessionBackend;

class SessionRecording {
    Q_DECLARE_TR_FUNCTIONS(SessionRecording)

public:
    SessionRecording(RobotSession& session, SessionBackend& backend) : session_(session), d_(backend) {}

    /// fields  by their RTDE names; empty: all
    /// every   every n-th packet becomes a row
    void start(const QString& path, const QStringList& fields = {}, int every = 1);
    void stop();

    // For the session.
    void reportFailure();

private:
    RobotSession& session_;
    SessionBackend& d_;
    bool wasRecording_ = false;
};

}  // namespace tiller
