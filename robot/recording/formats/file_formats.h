// SPDX-License-Identifier: MIT
#pragma once

// The file formats of recordings, one row per format. All other code takes suffixes, readers and writers from
// these rows, so a new format needs only one row.

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
    QByteArray magic;      ///< first bytes of a file; empty: any file that matches no other row
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

/// All formats, in the order of lists for users.
/// Threads  any
const std::vector<FileFormat>& fileFormats();
/// The row with the suffix of this path, ignoring case; null for other suffixes.
/// Threads  any
const FileFormat* fileFormatOf(const Text& path);
/// The usual suffixes as text, e.g. ".csv or .mcap".
/// recorded  only formats that a recorder can write
QString suffixWords(bool recorded);

}  // namespace tiller::recording
