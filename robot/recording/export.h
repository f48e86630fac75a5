// SPDX-License-Identifier: MIT
#pragma once

// A recording, or a part of it, into a file for other programs.

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "robot/core/text.h"
#include "robot/recording/recording.h"

namespace tiller::recording {

/// What goes into the file, whatever its format.
struct ExportChoice {
    Text path = {};  ///< an existing file is replaced, and only by a whole one
    std::vector<std::string> columns =
        {};           ///< by their names, or by that of a field for all its numbers; empty: all
    double from = 0;  ///< [s] on the time axis
    double until = std::numeric_limits<double>::infinity();  ///< [s]
    /// Told how much of it is done, 0 to 1. Returns  false: give up, with Cancelled
    std::function<bool(double)> progress = {};
};

struct CsvStyle {
    char separator = ',';    ///< , ; or tab
    char decimal = '.';      ///< . or , (not with , between cells)
    bool unitsLine = false;  ///< under the heading
};

struct ExportReport {
    std::uint64_t rows = 0;
    std::int64_t bytes = 0;  ///< size of the file
};

/// Columns by their names; a field's name stands for all its numbers.
/// Errors   FieldUnknown, naming each that is not there
Result<std::vector<std::size_t>> chooseColumns(const Recording& recording,
                                               const std::vector<std::string>& names);
/// The rows of a choice.
Result<RowRange> chooseRows(const Recording& recording, const ExportChoice& choice);

/// As text. Numbers are the shortest that read back exactly; what is missing is an empty cell.
/// Errors   FileNotWritable, DiskFull, FieldUnknown, InvalidArgument, Cancelled, and those of reading
/// Blocks   until it is written
Result<ExportReport> exportCsv(const Recording& recording, const ExportChoice& choice,
                               const CsvStyle& style = {});

}  // namespace tiller::recording
