// SPDX-License-Identifier: MIT
#pragma once

// Reads a recording back, column by column. Reads what others wrote too, as long as it is a header line and
// numbers.

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
    std::vector<std::vector<double>> values;  ///< one vector per column; NaN where a cell is empty
    /// True when the last line had no end (the writer was killed in the middle) and was left out.
    bool truncated = false;

    std::size_t rows() const { return values.empty() ? 0 : values.front().size(); }  ///< Without the heading.
    std::optional<std::size_t> indexOf(std::string_view column) const;  ///< Of a column by its heading.
    /// Null when there is no such column.
    const std::vector<double>* column(std::string_view name) const;
};

/// Errors   FileNotReadable; FileCorrupt with the line and what is wrong with it
/// Threads  any. Blocks: reads the whole file
Result<CsvTable> readCsv(const Text& path);

}  // namespace tiller::recording
