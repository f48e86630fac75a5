// SPDX-License-Identifier: MIT
#pragma once

// The mark of what a library offers; programs include this header by its name. Nothing has to be marked here.

#define RTDE_EXPORT
