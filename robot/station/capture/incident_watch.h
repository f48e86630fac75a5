// SPDX-License-Identifier: MIT
#pragma once

// Incident recorder of the window. It runs while a robot is connected, stores the events of the journal, and
// adds the file of each incident to the journal. The files also contain the additional fields displayed in
// plots.

#include <QObject>
#include <QString>

#include "robot/recording/mcap/black_box.h"
#include "robot/station/executor/serial_executor.h"
#include "robot/station/link/robot_session.h"

namespace tiller {

/// Threads  GUI; files are written in another thread
class IncidentWatch : public QObject {
    Q_OBJECT

public:
    /// folder  folder of the incident files, created when the first file is written
    IncidentWatch(RobotSession& session, const QString& folder, QObject* parent = nullptr);
    ~IncidentWatch() override;

    /// Sets the project stored in each file.
    void setProject(const QString& name, const QByteArray& content);
    /// Number of packets received on this connection.
    std::uint64_t packets() const { return box_.packets(); }

private:
    void restart();
    void followExtraFields();
    void learnIdentity();
    void report(const recording::Incident& incident);

    RobotSession& session_;
    const QString folder_;
    QString projectName_;
    QByteArray project_;
    recording::BlackBox box_;
    SerialExecutor worker_;  ///< last member, because its jobs use the black box
};

}  // namespace tiller
