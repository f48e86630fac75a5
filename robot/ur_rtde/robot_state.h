// SPDX-License-Identifier: MIT
#pragma once

// For compatibility with programs that include this header; use RTDEReceiveInterface to read the robot's state.

#include <ur_rtde/rtde.h>
