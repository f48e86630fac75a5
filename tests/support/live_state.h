// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Session states of a UR5e that is ready to move, for widget tests without a robot.

#include "robot/kinematics/arm_kinematics.h"
#include "robot/station/link/session_state.h"

namespace tiller::test {

inline const JointPositions kReadyJoints(-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310);

inline SessionState liveState(const JointPositions& q = kReadyJoints) {
    SessionState state;
    state.link = LinkState::Live;
    state.control = ControlState::InControl;
    state.robotMode = RobotMode::Running;
    state.safetyMode = SafetyMode::Normal;
    state.sequence = 1;
    state.q = q;
    state.tcpPose = kinematics::forwardTcp(robotModel(RobotModelId::UR5e).dh, q);
    return state;
}

/// Like liveState(), but with this TCP pose, which need not match the joint positions.
inline SessionState liveAt(const Pose& tcpPose) {
    SessionState state = liveState();
    state.tcpPose = tcpPose;
    return state;
}

/// Returns kReadyJoints with one joint rotated.
/// by  [rad]
inline JointPositions moved(int joint, double by) {
    JointPositions q = kReadyJoints;
    q[joint] += by;
    return q;
}

}  // namespace tiller::test
