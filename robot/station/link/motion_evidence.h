// SPDX-License-Identifier: MIT
#pragma once

#include "robot/control/stop_meter.h"

namespace tiller {

/// Returns whether the arm moves according to the data of the robot, with or without control.
/// jointSpeed  of the fastest joint [rad/s]
/// tcpSpeed    [m/s]
inline bool moves(double jointSpeed, double tcpSpeed) {
    constexpr double kStandstill = 0.0017;  // 0.1 deg/s, above the noise of an arm at standstill
    return jointSpeed > kStandstill || tcpSpeed >= control::kStillTcpSpeed;
}

}  // namespace tiller
