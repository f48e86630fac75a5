// SPDX-License-Identifier: MIT
#pragma once

// The lines above the header of a CSV file that describe the recording: "# name: value". The start time has
// the name "start", and the units of all columns have the name "units". Private to robot/recording.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "robot/recording/metadata.h"

namespace tiller::recording {

struct CsvHead {
    Metadata facts{};
    std::optional<std::int64_t> startUtcNs{};  ///< [ns since 1970]
    std::string units{};                       ///< cells of the line of units
};

/// units  one per column; empty: no line of units
std::string csvHeadLines(const Metadata& facts, std::optional<std::int64_t> startUtcNs,
                         std::span<const std::string> units, char separator);
/// Reads a comment line, including the number sign. Other comments are ignored.
void takeCsvHeadLine(std::string_view line, CsvHead& head);

}  // namespace tiller::recording
