// SPDX-License-Identifier: MIT
// Parsed once for the tests of robot/.
// A convenience of the build only: every file still names what it includes (TILLER_PRECOMPILE=OFF shows it).
#pragma once

#include "packaging/cmake/precompiled/robot.h"

#include <QTest>
