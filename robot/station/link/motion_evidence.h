// SPDX-License-Identifier: MIT
#pragma once

#include "robot/control/stop_meter.h"

namespace tiller {

/// True if the robot data show that the arm moves, with or without control.
/// jointSpeed  speed of the fastest joint [rad/s]
/// tcpSpeed    speed of the TCP [m/s]
inline bool moves(double jointSpeed, double tcpSpeed) {
    constexpr double kStandstill = 0.0017;  // 0.1 deg/s, above the noise at standstill
    return jointSpeed > kStandstill || tcpSpeed >= control::kStillTcpSpeed;
}

}  // namespace tiller
