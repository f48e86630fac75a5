// SPDX-License-Identifier: MIT
#pragma once

// The control program of the ur_rtde interface. Private to this room.

namespace tiller::urrtde {

/// rtde_control.script as it stands: without `def`, with version marks and the places for offsets and paths.
const char* controlProgram();

/// Behind this line stands the offset of the registers, in the built-in program and in customised ones.
inline constexpr const char* kOffsetPlace = "  # register offset\n";
inline constexpr const char* kFloatOffsetPlace = "# float register offset\n";
inline constexpr const char* kIntOffsetPlace = "# int register offset\n";
/// Behind this line stands the code of a path.
inline constexpr const char* kPathPlace = "# inject move path\n";

}  // namespace tiller::urrtde
