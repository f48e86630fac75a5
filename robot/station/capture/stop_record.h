// SPDX-License-Identifier: MIT
#pragma once

// Stores the last five seconds before a stop by the safety system, at the full data rate of the robot, and
// the controller messages about the stop.

#include <QObject>
#include <QStringList>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "robot/receive/sample.h"
#include "robot/station/link/robot_session.h"

namespace tiller {

struct StopRecord {
    struct Point {
        double time = 0;                      ///< the controller's time stamp [s]
        double force = 0;                     ///< force at the TCP [N]
        double speed = 0;                     ///< TCP speed [m/s]
        Vector6 current = Vector6::Zero();    ///< joint currents [A]
        Vector6 deviation = Vector6::Zero();  ///< measured minus target current [A]
    };

    SafetyStatus status = SafetyMode::Undefined;
    double stoppedAt = 0;  ///< the controller's time stamp [s]
    std::vector<Point> points;
    Pose tcpPose;
    JointPositions q;
    int suspect = -1;     ///< joint with the largest current deviation, 0..5; -1: no clear deviation
    QStringList reports;  ///< controller messages within two seconds of the stop, e.g. "C157 Collision ..."
};

/// Threads  GUI
class StopRecorder : public QObject {
    Q_OBJECT

public:
    explicit StopRecorder(RobotSession& session, QObject* parent = nullptr);

    /// The last stop of this connection; empty if no stop has occurred.
    const std::optional<StopRecord>& last() const { return record_; }
    /// Time since the stop on the controller's clock [s]; 0 without a stop.
    double secondsSince() const;

    static constexpr double kSeconds = 5.0;

Q_SIGNALS:
    /// A stop was recorded, or more messages about the last stop have arrived.
    void changed();

private:
    void forget();
    void follow(const SampleBatch& batch);
    void take(const receive::Sample& sample);
    void freeze(const receive::Sample& sample, SafetyStatus status);
    void hear(const script::ControllerMessage& message);

    std::deque<StopRecord::Point> points_;
    std::deque<std::pair<double, QString>> said_;
    bool stopped_ = false;
    std::uint64_t connection_ = 0;  ///< connection of the last sample
    JointPositions q_;              ///< arm position in the last sample
    double now_ = 0;
    std::optional<StopRecord> record_;
};

}  // namespace tiller
