// SPDX-License-Identifier: MIT
#pragma once

// The notes, warnings and errors of a CSV recording. A table of numbers cannot contain text, so they are in a
// second CSV file next to the recording, with the columns row, utc, level, source and text.

#include <QString>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "robot/core/result.h"
#include "robot/recording/recording.h"
#include "robot/recording/recording_format.h"

namespace tiller::recording {

/// True for notes of the operator, warnings and errors. Other log lines would create a second file for every
/// recording.
bool isCsvNote(int level, const QString& source);
/// "a.csv" becomes "a.notes.csv".
QString csvNotesPath(const QString& recording);
/// Removes the notes of an earlier recording with this name.
/// Errors  FileNotWritable if a file with this name was not written by a recorder; that file is kept
Result<void> removeCsvNotes(const QString& recording);
std::string csvNotesHeader();
/// row  number of rows before the note
std::string csvNoteLine(std::uint64_t row, const RecordedNote& note);
/// Reads the notes file of a recording; empty if it does not exist. Unreadable lines are skipped. Each note
/// is returned with the number of rows before it, without a time.
std::vector<std::pair<std::uint64_t, RecordedEvent>> readCsvNotes(const QString& recording);

}  // namespace tiller::recording
