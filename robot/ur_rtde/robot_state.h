// SPDX-License-Identifier: MIT
#pragma once

// Programs include this header by its name; the robot's state is read with RTDEReceiveInterface.

#include <ur_rtde/rtde.h>
