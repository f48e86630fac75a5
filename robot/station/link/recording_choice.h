// SPDX-License-Identifier: MIT
#pragma once

// Recording settings of the operator: folder and file name, recorded signals, and the number of packets per
// row.

#include <QDateTime>
#include <QString>
#include <QStringList>

#include "robot/recording/formats/file_formats.h"

namespace tiller {

struct RecordingChoice {
    QString folder{};                        ///< empty: recordingFolder()
    QString pattern = defaultPattern();      ///< pattern of the file name; see recordingPath()
    QStringList fields{};                    ///< RTDE names; empty: all of recordableFields()
    int every = 1;                           ///< every n-th packet becomes a row
    QString format = QStringLiteral("csv");  ///< usual suffix of a row of recording::fileFormats()
    int keepFree = 200;                      ///< stops recording when less is free on the disk [MB]

    static constexpr int kMaxDecimation = 500;
    static constexpr int kMaxKeptFree = 100'000;  ///< [MB]
    static QString defaultPattern() { return QStringLiteral("{date}_{time}"); }

    /// Returns the nearest valid choice.
    RecordingChoice sane() const;

    friend bool operator==(const RecordingChoice&, const RecordingChoice&) = default;
};

/// The row of a format that a recorder can write; CSV for unknown names.
const recording::FileFormat& recordingFormat(const QString& suffix);

/// Translated words for a format.
struct RecordingFormatWords {
    QString choice;      ///< in a list of formats
    QString button;      ///< accessible name of the button that starts a recording
    QString buttonHint;  ///< its tooltip
};
RecordingFormatWords recordingFormatWords(const recording::FileFormat& format);
/// Fields that every robot can record.
QStringList recordableFields();
/// "Tiller" in the user's documents folder.
QString recordingFolder();
/// The error of a pattern, as a sentence; empty if it is valid.
QString patternProblem(const QString& pattern);
/// The path of a new file: {date}, {time} and {robot} of the pattern are replaced, and {number} continues
/// after the existing files. Never the path of an existing file.
QString recordingPath(const RecordingChoice& choice, const QString& robot, const QDateTime& now);

}  // namespace tiller
