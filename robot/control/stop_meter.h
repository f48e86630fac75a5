// SPDX-License-Identifier: MIT
#pragma once

// Measures how long and how far the arm still moved after a stop was asked for, on what the robot reports.

#include <Eigen/Core>
#include <cstdint>

#include "robot/control/motion_types.h"

namespace tiller::control {

/// Slower than this counts as standing: below the noise of a standing arm would be never.
inline constexpr double kStillTcpSpeed = 0.001;     ///< [m/s]
inline constexpr double kStillJointSpeed = 0.0035;  ///< [rad/s] 0.2 deg/s

/// Threads  one. Real-time: yes
class StopMeter {
public:
    struct Sample {
        std::int64_t hostNs = 0;  ///< when it was received
        Eigen::Vector3d tcpPosition = Eigen::Vector3d::Zero();
        double tcpSpeed = 0;    ///< [m/s]
        double jointSpeed = 0;  ///< of the fastest joint [rad/s]
    };

    /// requestNs  when the stop was asked for. One that is being measured is finished as it is.
    void begin(StopCause cause, std::int64_t requestNs);
    void cancel() { measuring_ = false; }  ///< Forgets the stop under way.
    /// Returns  true when this sample completed a measurement
    bool add(const Sample& sample);

    bool isMeasuring() const { return measuring_; }        ///< From the stop to standstill.
    bool isMoving() const { return moving_; }              ///< By the newest data.
    const StopMeasurement& last() const { return last_; }  ///< The newest that was complete.

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
};

}  // namespace tiller::control
