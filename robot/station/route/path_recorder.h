// SPDX-License-Identifier: MIT
#pragma once

// "Record path": what the arm does, led by hand or jogged, from the press on the key until the next one, kept as
// waypoints that come within a stated tolerance of every place that was recorded. Recording moves nothing. The same
// for a demonstration from a file, and the way back into one.

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
    /// Both must outlive it.
    PathRecorder(RobotSession& session, ProjectDocument& document, QObject* parent = nullptr);
    ~PathRecorder() override;

    bool isRecording() const { return recording_; }
    /// Of what is being recorded [s].
    double seconds() const;
    /// While what was recorded or read is being thinned.
    bool isBusy() const { return busy_; }

    const project::PathTolerance& tolerance() const { return tolerance_; }
    void setTolerance(const project::PathTolerance& tolerance) { tolerance_ = tolerance; }

    /// Does nothing, and says why by refused(), where no data come.
    void start();
    /// Keeps what was recorded, behind this row (-1: at the end).
    void stop(int afterRow);
    /// Forgets it.
    void abandon();
    /// Reads a demonstration and keeps it behind this row.
    void importFrom(const QString& path, int afterRow);
    /// The way along these rows as a demonstration: straight between them in joint space, at their own speeds.
    /// Errors  InvalidArgument (fewer than two rows, one out of reach), FileNotWritable, DiskFull
    Result<void> exportTo(const QString& path, const QList<int>& rows) const;

    /// What a recording that is not ended ends by itself [s].
    static constexpr double kLongest = 600;
    /// Of the samples of an exported demonstration [s].
    static constexpr double kExportPeriod = 0.008;

Q_SIGNALS:
    /// isRecording(), seconds() or isBusy() is another one.
    void changed();
    /// It ended by itself: the data stopped, or it was too long. stop() has to be called to keep it.
    void ended();
    /// A path was kept: what was recorded and what became of it, as a sentence.
    void kept(const QString& summary);
    /// Nothing was kept: why.
    void refused(const QString& reason, const QString& details);

private:
    void take(const SampleBatch& batch);
    void thin(project::Demonstration shown, int afterRow);
    void insert(const std::vector<project::KeptPlace>& places, double seconds, int afterRow);
    QString nextPathName() const;

    RobotSession& session_;
    ProjectDocument& document_;
    project::PathTolerance tolerance_{0.0175, 0.002};
    project::Demonstration shown_;
    Pose tcpOffset_;
    bool recording_ = false;
    bool busy_ = false;
    std::uint64_t lost_ = 0;
    int shownSecond_ = -1;
    SerialExecutor worker_;  // last: its jobs use what stands above
};

}  // namespace tiller
