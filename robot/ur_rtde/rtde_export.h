// SPDX-License-Identifier: MIT
#pragma once

// Export macros, for compatibility with programs that include this header; not needed here.

#define RTDE_EXPORT
