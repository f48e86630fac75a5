// SPDX-License-Identifier: MIT
#pragma once

// Implements "Record path": records the motion of the arm during hand guiding or jogging, between two presses
// of the button, and reduces it to waypoints within a tolerance. Recording does not move the arm. Also
// imports and exports paths.

#include <QObject>
#include <memory>
#include <optional>

#include "robot/project/demonstration.h"
#include "robot/station/executor/serial_executor.h"
#include "robot/station/link/robot_session.h"

namespace tiller {

class ProjectDocument;

class PathRecorder : public QObject {
    Q_OBJECT

public:
    /// Both arguments must outlive the object.
    PathRecorder(RobotSession& session, ProjectDocument& document, QObject* parent = nullptr);
    ~PathRecorder() override;

    bool isRecording() const { return recording_; }
    /// Duration of the current recording [s].
    double seconds() const;
    /// True while a recording or an imported file is being reduced.
    bool isBusy() const { return busy_; }

    const project::PathTolerance& tolerance() const { return tolerance_; }
    void setTolerance(const project::PathTolerance& tolerance) { tolerance_ = tolerance; }

    void start();
    /// Adds the recorded path after this row (-1: at the end).
    void stop(int afterRow);
    /// Discards the recording.
    void abandon();
    /// Imports a path and adds it after this row.
    void importFrom(const QString& path, int afterRow);
    /// Exports the path through these rows: linear in joint space, at the waypoint speeds.
    /// Errors  InvalidArgument (fewer than two rows, or an unreachable waypoint), FileNotWritable, DiskFull
    Result<void> exportTo(const QString& path, const QList<int>& rows) const;

    /// Maximum duration of a recording [s].
    static constexpr double kLongest = 600;
    /// Sample period of an exported path [s].
    static constexpr double kExportPeriod = 0.008;

Q_SIGNALS:
    /// Emitted when isRecording(), seconds() or isBusy() has changed.
    void changed();
    /// The recording has ended because no data arrive, the controller has restarted, or the maximum duration
    /// is reached. Call stop() to keep the recorded path.
    void ended();
    /// A path was added. `summary` describes the recording and the result.
    void kept(const QString& summary);
    /// No path was added. `reason` explains why.
    void refused(const QString& reason, const QString& details);

private:
    void take(const SampleBatch& batch);
    void end();
    void thin(project::Demonstration shown, int afterRow);
    void insert(const std::vector<project::KeptPlace>& places, double seconds, int afterRow);
    QString nextPathName() const;

    RobotSession& session_;
    ProjectDocument& document_;
    project::PathTolerance tolerance_{0.0175, 0.002};
    project::Demonstration shown_;
    Pose tcpOffset_;
    bool recording_ = false;
    bool hasEnded_ = false;  ///< true after ended(), until the path is kept or discarded
    bool busy_ = false;
    std::uint64_t lost_ = 0;
    int shownSecond_ = -1;
    SerialExecutor worker_;  // last member, because its jobs use the members above
};

}  // namespace tiller
