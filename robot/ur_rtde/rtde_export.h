// SPDX-License-Identifier: MIT
#pragma once

// Export macros. Exist for compatibility with programs that include this header.

#define RTDE_EXPORT
