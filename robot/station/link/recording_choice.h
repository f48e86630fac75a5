// SPDX-License-Identifier: MIT
#pragma once

// Recording settings of the operator: folder and file name, recorded signals, and the number of packets per
// row.

#include <QDateTime>
#include <QString>
#include <QStringList>

namespace tiller {

struct RecordingChoice {
    enum class Format {
        Csv,   ///< one row per packet, for any program that reads text
        Mcap,  ///< every field with its type, including log and project
    };
    QString folder{};                    ///< empty: recordingFolder()
    QString pattern = defaultPattern();  ///< pattern of the file name; see recordingPath()
    QStringList fields{};                ///< RTDE names; empty: all of recordableFields()
    int every = 1;                       ///< every n-th packet becomes a row
    Format format = Format::Csv;
    int keepFree = 200;  ///< stops recording when less is free on the disk [MB]

    static constexpr int kMaxDecimation = 500;
    static constexpr int kMaxKeptFree = 100'000;  ///< [MB]
    static QString defaultPattern() { return QStringLiteral("{date}_{time}"); }

    /// Returns the nearest valid choice.
    RecordingChoice sane() const;

    friend bool operator==(const RecordingChoice&, const RecordingChoice&) = default;
};

/// "csv", "mcap": the file name suffix, and the name in the settings.
QString formatName(RecordingChoice::Format format);
/// Returns CSV for unknown names.
RecordingChoice::Format formatByName(const QString& name);
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
