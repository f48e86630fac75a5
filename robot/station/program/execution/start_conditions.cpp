// SPDX-License-Identifier: MIT
#include "robot/station/program/execution/start_conditions.h"

#include "robot/station/program/program_text.h"

namespace tiller::program {

bool isSameTcp(const Pose& a, const Pose& b) {
    constexpr double kSamePosition = 1e-4;  // [m]
    constexpr double kSameRotation = 1e-3;  // [rad]
    return (a.position - b.position).norm() < kSamePosition &&
           (a.transform().linear() - b.transform().linear()).norm() < kSameRotation;
}

QString otherTcpText() {
    return ProgramText::tr(
        "The TCP of the robot differs from the TCP of the program's waypoints. Set the active TCP of the "
        "project, or use a TCP section.");
}

bool isAtStart(const JointPositions& start, const JointPositions& q) {
    constexpr double kAtStart = 0.01;  // [rad] for each joint
    return (start.values - q.values).cwiseAbs().maxCoeff() < kAtStart;
}

QString notAtStartText() {
    return ProgramText::tr("Move the arm to the start position first.");
}

}  // namespace tiller::program
