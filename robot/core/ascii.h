// SPDX-License-Identifier: MIT
#pragma once

// Character functions for the robot's text protocols, which are pure ASCII.

#include <cctype>
#include <string_view>

namespace tiller {

/// Removes blanks (space, tab, carriage return, line feed) at both ends.
constexpr std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlank = " \t\r\n";
    const std::size_t first = text.find_first_not_of(kBlank);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// Converts A-Z to lower case; returns other characters unchanged.
inline char lower(char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

}  // namespace tiller
