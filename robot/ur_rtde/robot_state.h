// SPDX-License-Identifier: MIT
#pragma once

// Exists for compatibility with programs that include this header. Use RTDEReceiveInterface to read the
// robot's state.

#include <ur_rtde/rtde.h>
