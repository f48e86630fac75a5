// SPDX-License-Identifier: MIT
#pragma once

// The black box of the window: runs while there is a robot, hears what the log hears, and tells where the file of an
// incident is.

#include <QObject>
#include <QString>

#include "robot/recording/mcap/black_box.h"
#include "robot/station/executor/serial_executor.h"
#include "robot/station/link/robot_session.h"

namespace tiller {

/// Threads  GUI; files are written elsewhere
class IncidentWatch : public QObject {
    Q_OBJECT

public:
    /// folder  where the files go; it is made with the first of them
    IncidentWatch(RobotSession& session, const QString& folder, QObject* parent = nullptr);
    ~IncidentWatch() override;

    /// What a file keeps as the project.
    void setProject(const QString& name, const QByteArray& content);
    /// Of the robot, seen in this link so far.
    std::uint64_t packets() const { return box_.packets(); }

Q_SIGNALS:
    /// text    a sentence about it; detail  what to do with it
    /// path    of the file; empty when it could not be written
    void told(tiller::Severity severity, const QString& text, const QString& detail, const QString& path);

private:
    void restart();
    void learnIdentity();
    void tell(const recording::Incident& incident);

    RobotSession& session_;
    const QString folder_;
    QString projectName_;
    QByteArray project_;
    recording::BlackBox box_;
    SerialExecutor worker_;  ///< last: its jobs use the box
};

}  // namespace tiller
