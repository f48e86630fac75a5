// SPDX-License-Identifier: MIT
#pragma once

// Measures the stopping time and distance after a stop request, using data from the robot.

#include <Eigen/Core>
#include <cstdint>

#include "robot/control/motion_types.h"

namespace tiller::control {

/// Speeds below these values are standstill. The values exceed the measurement noise at standstill.
inline constexpr double kStillTcpSpeed = 0.001;     ///< [m/s]
inline constexpr double kStillJointSpeed = 0.0035;  ///< [rad/s] 0.2 deg/s

/// Threads  one. Real-time: yes
class StopMeter {
public:
    struct Sample {
        std::int64_t hostNs = 0;  ///< arrival time
        Eigen::Vector3d tcpPosition = Eigen::Vector3d::Zero();
        double tcpSpeed = 0;    ///< [m/s]
        double jointSpeed = 0;  ///< speed of the fastest joint [rad/s]
    };

    /// requestNs  time of the stop request. Does not interrupt a measurement in progress.
    void begin(StopCause cause, std::int64_t requestNs);
    void cancel() { measuring_ = false; }  ///< Cancels the measurement in progress.
    /// Ends the measurement in progress without a result and counts it in lastUnmeasured().
    void abandon(UnmeasuredStop::Reason reason);
    /// Returns  true if this sample completed a measurement
    bool add(const Sample& sample);

    bool isMeasuring() const { return measuring_; }        ///< True from the stop request to standstill.
    bool isMoving() const { return moving_; }              ///< True if the newest data report motion.
    const StopMeasurement& last() const { return last_; }  ///< The last complete measurement.
    const UnmeasuredStop& lastUnmeasured() const { return unmeasured_; }

private:
    bool measuring_ = false;
    bool moving_ = false;
    bool hasSample_ = false;
    int stillSamples_ = 0;
    StopCause cause_ = StopCause::None;
    std::int64_t requestNs_ = 0;
    std::int64_t stillSinceNs_ = 0;
    double path_ = 0;
    double pathAtStill_ = 0;
    Sample previous_;
    StopMeasurement last_;
    UnmeasuredStop unmeasured_;
};

}  // namespace tiller::control
