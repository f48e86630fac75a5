// SPDX-License-Identifier: MIT
#pragma once

// The file formats of recordings, one row per format. Dialogs, settings, the options of tiller-cli and their
// help, Python and detection on opening use these rows, so a new format needs only its reader, its writer and
// one row.

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <memory>
#include <vector>

#include "robot/core/text.h"
#include "robot/recording/export.h"
#include "robot/recording/mcap/mcap_format.h"
#include "robot/recording/recording.h"
#include "robot/recording/recording_format.h"
#include "robot/recording/table_format.h"

namespace tiller::recording {

struct FileFormat {
    QString name;          ///< Recording::format(), e.g. "MCAP"
    QStringList suffixes;  ///< lower case, without the period; new files get the first suffix
    QByteArray magic;      ///< first bytes of a file, at most 8; empty: any file that matches no other row
    QString readers;       ///< programs that read it, in English, e.g. "pandas and spreadsheets"
    const char* label;     ///< text in lists of formats for recording, translated in the context
                           ///< tiller::PlotDock; null if `recorder` is null
    /// Errors and threads: same as openRecording().
    Result<std::unique_ptr<Recording>> (*open)(const Text& path, const TableFormat& format);
    /// Errors and threads: same as exportRecording(). `style` only affects CSV.
    Result<ExportReport> (*write)(const Recording& recording, const ExportChoice& choice,
                                  const CsvStyle& style);
    /// For RecorderOptions::format; null: a recorder cannot write this format.
    /// extras  facts, attachment and messages; ignored by formats that are not complete
    /// csvHead  CSV files begin with the facts, the start time and the units; see csvFormat()
    std::shared_ptr<const RecordingFormat> (*recorder)(const McapFormatOptions& extras, bool csvHead);
    /// Keeps every field, the log and an attachment. For other formats, fields must be selected.
    bool isComplete;
};

enum class FormatSet {
    All,       ///< every format can be opened and exported
    Recorded,  ///< formats that a recorder can write
    Complete,  ///< formats that a recorder can write and that are complete
    Selected,  ///< formats that a recorder can write and for which fields must be selected
};

/// All formats, in the order of lists for users.
/// Threads  any
const std::vector<FileFormat>& fileFormats();
/// The rows of a set, in the same order. No set is empty.
/// Threads  any
std::vector<const FileFormat*> formatsIn(FormatSet set);
/// The row with the suffix of this path, ignoring case; null for other suffixes.
/// Threads  any
const FileFormat* fileFormatOf(const Text& path);
/// The row of a file that begins with these bytes.
/// begin   at least the first 8 bytes, or the complete file
/// Threads  any
const FileFormat& fileFormatOfContent(const QByteArray& begin);

/// The first suffix of each format as text for users, e.g. ".csv or .mcap".
/// before  text before each suffix, e.g. "FILE"
QString suffixWords(FormatSet set, const QString& before = {});
/// All suffixes with the programs that read them, e.g. ".csv for pandas and spreadsheets, or .mcap for ROS
/// tools".
QString suffixHelp(FormatSet set);
/// Name filters of all suffixes for a file dialog, e.g. "*.csv *.mcap".
QString suffixFilter(FormatSet set);

}  // namespace tiller::recording
