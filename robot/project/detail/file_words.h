// SPDX-License-Identifier: MIT
#pragma once

// Words in project files for enumeration values, in the order of the values.

#include <array>

namespace tiller::project {

inline constexpr std::array kMoveWords = {"J", "L"};
inline constexpr std::array kTargetWords = {"joints", "pose"};
inline constexpr std::array kOrderWords = {"rows", "meander"};
inline constexpr std::array kIoGroupWords = {"standard", "configurable", "tool"};
inline constexpr std::array kColourWords = {"none", "blue", "orange", "green", "pink", "yellow", "sky"};

}  // namespace tiller::project
