// SPDX-License-Identifier: MIT
// Parsed once for the tests with a window.
// A convenience of the build only: every file still names what it includes (TILLER_PRECOMPILE=OFF shows it).
#pragma once

#include "packaging/cmake/precompiled/widgets.h"

#include <QTest>
