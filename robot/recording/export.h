// SPDX-License-Identifier: MIT
#pragma once

// Exports a recording or a part of it to a file for other programs.

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/text.h"
#include "robot/recording/recording.h"
#include "robot/recording/recording_format.h"

namespace tiller::recording {

/// Selection of the data to export, independent of the format.
struct ExportChoice {
    Text path = {};  ///< an existing file is replaced atomically
    /// Names of columns, or of fields for all their components; empty: all. Text and MCAP files always
    /// contain the time column of the recording. A time column that is not listed becomes the first column.
    /// HDF5 files contain `time`, and so do text files if the recording has no time column.
    std::vector<std::string> columns = {};
    double from = 0;                                         ///< [s] on the time axis
    double until = std::numeric_limits<double>::infinity();  ///< [s]
    /// Called with the completed fraction, 0 to 1. Returning false cancels the export with Cancelled.
    std::function<bool(double)> progress = {};
};

struct CsvStyle {
    char separator = ',';    ///< comma, semicolon or tab
    char decimal = '.';      ///< point or comma; comma only if it is not the separator
    bool unitsLine = false;  ///< add a line of units after the header
    /// Add the start time, the metadata and the units above the header, one line "# name: value" each.
    bool head = false;
};

struct ExportReport {
    std::uint64_t rows = 0;
    std::int64_t bytes = 0;  ///< size of the file
};

/// Selects columns by name. The name of a field selects all its components.
/// Errors   FieldUnknown with all missing names
Result<std::vector<std::size_t>> chooseColumns(const Recording& recording,
                                               const std::vector<std::string>& names);
/// See Recording::timeColumn().
std::optional<std::size_t> timeColumn(const Recording& recording);
/// Like chooseColumns(), but adds the time column of the recording as the first column if it is missing.
Result<std::vector<std::size_t>> columnsWithTime(const Recording& recording,
                                                 const std::vector<std::string>& names);
/// Text of a cell, quoted as in RFC 4180 where necessary.
std::string csvCell(std::string_view text, char separator = ',');
/// The shortest text that converts back to the same number, independent of the locale; empty for NaN.
std::string csvNumber(double value);
/// Like csvNumber(double).
std::string csvNumber(float value);
/// The selected rows.
Result<RowRange> chooseRows(const Recording& recording, const ExportChoice& choice);

/// A note of a CSV file.
struct RowNote {
    std::uint64_t row = 0;  ///< number of rows before the note
    RecordedNote note;
};
/// Writes the notes, warnings and errors of the CSV file `path` to a second file, "a.notes.csv" for "a.csv".
/// If there are none, removes an older second file.
/// Errors  FileNotWritable, DiskFull
Result<void> writeCsvNotes(const Text& path, const std::vector<RowNote>& notes);

/// Writes a text file. Numbers are written as the shortest text that converts back exactly; missing values
/// are empty cells. Notes, warnings and errors are written to a second file, "a.notes.csv" for "a.csv".
/// Errors   FileNotWritable, DiskFull, FieldUnknown, InvalidArgument, Cancelled, and read errors
/// Blocks   until the file is written
Result<ExportReport> exportCsv(const Recording& recording, const ExportChoice& choice,
                               const CsvStyle& style = {});

}  // namespace tiller::recording
