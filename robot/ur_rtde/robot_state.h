// SPDX-License-Identifier: MIT
#pragma once

// For programs that include this header. RTDEReceiveInterface reads the state of the robot.

#include <ur_rtde/rtde.h>
