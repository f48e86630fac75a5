// SPDX-License-Identifier: MIT
#pragma once

// Empty header for programs that include it by name. RTDEReceiveInterface reads the state of the robot.

#include <ur_rtde/rtde.h>
