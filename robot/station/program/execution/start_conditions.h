// SPDX-License-Identifier: MIT
#pragma once

// Determines whether a checked program fits the TCP and the position of the robot, with texts for the reasons
// if it does not.

#include <QString>

#include "robot/core/joints.h"
#include "robot/core/spatial.h"

namespace tiller::program {

bool isSameTcp(const Pose& a, const Pose& b);
/// Why a program whose waypoints have another TCP must not run, as a sentence.
QString otherTcpText();

/// True if each joint is within 0.01 rad of its start position.
bool isAtStart(const JointPositions& start, const JointPositions& q);
/// Why a program must not run if the arm is not at its start, as a sentence.
QString notAtStartText();

}  // namespace tiller::program
