// SPDX-License-Identifier: MIT
// Precompiled header of the tests of robot/. It only speeds up the build. Each source file still includes all
// headers that it uses; a build with TILLER_PRECOMPILE=OFF checks this.
#pragma once

#include "packaging/cmake/precompiled/robot.h"

#include <QTest>
