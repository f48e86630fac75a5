// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/session/move_time.h"

#include <algorithm>

#include "robot/kinematics/speed_bounds.h"

namespace tiller {

double moveSeconds(const MoveRequest& request, const SessionState& state) {
    double distance = 0;
    if (request.kind == MoveRequest::Kind::MoveJ) {
        distance = (request.q.values - state.q.values).cwiseAbs().maxCoeff();
    } else {
        distance = kinematics::lineLength(state.tcpPose, request.pose);
    }
    constexpr double kLeastFraction = 0.02;  // of the slider
    return kinematics::moveDuration(distance, request.speed, request.acceleration) /
           std::max(state.speedFraction, kLeastFraction);
}

}  // namespace tiller
