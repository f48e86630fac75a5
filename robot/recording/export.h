// SPDX-License-Identifier: MIT
#pragma once

// Exports a recording, or a part of it, to a file for other programs.

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "robot/core/text.h"
#include "robot/recording/recording.h"

namespace tiller::recording {

/// The selected content, independent of the format.
struct ExportChoice {
    Text path = {};  ///< an existing file is replaced atomically
    std::vector<std::string> columns =
        {};           ///< names of columns, or of fields for all their components; empty: all
    double from = 0;  ///< [s] on the time axis
    double until = std::numeric_limits<double>::infinity();  ///< [s]
    /// Called with the completed fraction, 0 to 1. Returning false cancels with Cancelled
    std::function<bool(double)> progress = {};
};

struct CsvStyle {
    char separator = ',';    ///< comma, semicolon or tab
    char decimal = '.';      ///< point or comma (no comma if it separates the cells)
    bool unitsLine = false;  ///< add a line of units below the header
};

struct ExportReport {
    std::uint64_t rows = 0;
    std::int64_t bytes = 0;  ///< size of the file
};

/// Selects columns by name; the name of a field selects all its components.
/// Errors   FieldUnknown, with all missing names
Result<std::vector<std::size_t>> chooseColumns(const Recording& recording,
                                               const std::vector<std::string>& names);
/// The selected rows.
Result<RowRange> chooseRows(const Recording& recording, const ExportChoice& choice);

/// Writes a text file. Numbers are the shortest that read back exactly; missing values are empty cells.
/// Errors   FileNotWritable, DiskFull, FieldUnknown, InvalidArgument, Cancelled, and read errors
/// Blocks   until the file is written
Result<ExportReport> exportCsv(const Recording& recording, const ExportChoice& choice,
                               const CsvStyle& style = {});

}  // namespace tiller::recording
