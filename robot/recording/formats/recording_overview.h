// SPDX-License-Identifier: MIT
#pragma once

// A short description of a recording, for lists of the recordings in a folder.

#include <QDateTime>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <vector>

#include "robot/core/result.h"
#include "robot/core/text.h"
#include "robot/recording/metadata.h"

namespace tiller::recording {

struct RecordingOverview {
    QString path{};
    QString format{};   ///< as Recording::format()
    QDateTime start{};  ///< time of the first row; if the file does not contain it, time of the last change
                        ///< of the file
    double seconds = 0;
    std::uint64_t rows = 0;
    std::int64_t bytes = 0;
    Metadata facts{};
    QStringList notes{};  ///< notes of the operator and causes of triggers
    /// Name of the signal shown as a curve: the TCP force along Z or, if the recording does not contain this
    /// force, another column. Empty for long recordings without summaries, because all rows would have to be
    /// read.
    QString signal{};
    std::vector<double> low{};  ///< minimum of each part of the recording; NaN without values
    std::vector<double> high{};

    /// The user's metadata as text, e.g. "operator=Ann, sample=7".
    QString metadataText() const;
    /// True if the file name, the start, the facts and the notes contain all words, ignoring case.
    bool matches(const QString& words) const;
};

/// Errors  as openRecording()
/// Blocks  while the file is opened
Result<RecordingOverview> recordingOverview(const Text& path);
/// The files in a folder that have the suffix of a format, most recently changed first. Files with notes of
/// recordings are not included.
QStringList recordingsIn(const QString& folder);

}  // namespace tiller::recording
