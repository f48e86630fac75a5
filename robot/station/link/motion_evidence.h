// SPDX-License-Identifier: MIT
#pragma once

#include "robot/control/stop_meter.h"

namespace tiller {

/// True if the arm moves according to robot data, with or without control.
/// jointSpeed  of the fastest joint [rad/s]
/// tcpSpeed    [m/s]
inline bool moves(double jointSpeed, double tcpSpeed) {
    constexpr double kStandstill = 0.0017;  // 0.1 deg/s, above the noise at standstill
    return jointSpeed > kStandstill || tcpSpeed >= control::kStillTcpSpeed;
}

}  // namespace tiller
