// SPDX-License-Identifier: MIT
// Precompiled header of the tests with a window. It only speeds up the build. Each source file still includes
// all headers that it uses; a build with TILLER_PRECOMPILE=OFF checks this.
#pragma once

#include "packaging/cmake/precompiled/widgets.h"

#include <QTest>
