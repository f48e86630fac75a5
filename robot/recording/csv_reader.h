// SPDX-License-Identifier: MIT
#pragma once

// Reads a recording, or any other file with a header line and numbers, into columns.

#include <QString>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "robot/core/text.h"

namespace tiller::recording {

struct CsvTable {
    std::vector<std::string> columns;
    std::vector<std::vector<double>> values;  ///< one vector per column; NaN for an empty cell
    /// True if the last line was incomplete and was skipped, e.g. because the writer was killed.
    bool truncated = false;

    std::size_t rows() const { return values.empty() ? 0 : values.front().size(); }  ///< Without the header.
    std::optional<std::size_t> indexOf(std::string_view column) const;  ///< Index of a column by its name.
    /// Values of a column; null if the column does not exist.
    const std::vector<double>* column(std::string_view name) const;
};

/// Errors   FileNotReadable; FileCorrupt with line and reason
/// Threads  any. Blocks: reads the whole file
Result<CsvTable> readCsv(const Text& path);

}  // namespace tiller::recording
