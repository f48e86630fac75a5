// SPDX-License-Identifier: MIT
#pragma once

// Characters of the robot's text protocols, which know no others than those of ASCII.

#include <cctype>
#include <string_view>

namespace tiller {

/// Without the blanks (space, tab, carriage return, line feed) at both ends.
constexpr std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlank = " \t\r\n";
    const std::size_t first = text.find_first_not_of(kBlank);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// The small letter of a capital one; everything else is as it was.
inline char lower(char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

}  // namespace tiller
