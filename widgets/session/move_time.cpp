// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/session/move_time.h"

#include <algorithm>

#include "robot/kinematics/speed_bounds.h"
#include "robot/project/reachability.h"

namespace tiller {

double moveSeconds(const MoveRequest& request, const SessionState& state) {
    double distance = 0;
    if (request.kind == MoveRequest::Kind::MoveJ) {
        distance = (request.q.values - state.q.values).cwiseAbs().maxCoeff();
    } else {
        const Eigen::Matrix3d turn =
            rotationMatrix(request.pose.rotation) * rotationMatrix(state.tcpPose.rotation).transpose();
        // A line that only turns is led by its turn.
        distance = std::max((request.pose.position - state.tcpPose.position).norm(),
                            rotationVector(turn).norm() * kinematics::kTurnRadius);
    }
    constexpr double kLeastFraction = 0.02;  // of the slider
    return project::moveDuration(distance, request.speed, request.acceleration) /
           std::max(state.speedFraction, kLeastFraction);
}

}  // namespace tiller
