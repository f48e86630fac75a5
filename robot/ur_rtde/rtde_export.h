// SPDX-License-Identifier: MIT
#pragma once

// Export macros, for programs that include this header.

#define RTDE_EXPORT
