// SPDX-License-Identifier: MIT
#pragma once

// Recording settings chosen by the operator: folder, file name, recorded signals, and the number of packets
// per row.

#include <QDateTime>
#include <QString>
#include <QStringList>

namespace tiller {

struct RecordingChoice {
    enum class Format {
        Csv,   ///< one row per packet, for any program that reads text
        Mcap,  ///< every field with its type, including log and project
    };
    QString folder{};                    ///< if empty, recordingFolder()
    QString pattern = defaultPattern();  ///< pattern of the file name; see recordingPath()
    QStringList fields{};                ///< RTDE names; empty: all of recordableFields()
    int every = 1;                       ///< every n-th packet becomes a row
    Format format = Format::Csv;
    int keepFree = 200;  ///< minimum free disk space; recording stops below it [MB]

    static constexpr int kMaxDecimation = 500;
    static constexpr int kMaxKeptFree = 100'000;  ///< [MB]
    static QString defaultPattern() { return QStringLiteral("{date}_{time}"); }

    /// Returns the settings with invalid values replaced by the nearest valid ones.
    RecordingChoice sane() const;

    friend bool operator==(const RecordingChoice&, const RecordingChoice&) = default;
};

/// "csv" or "mcap": the file name suffix, and the name in the settings.
QString formatName(RecordingChoice::Format format);
/// Returns CSV for unknown names.
RecordingChoice::Format formatByName(const QString& name);
/// Fields that every robot can record.
QStringList recordableFields();
/// The folder "Tiller" in the user's documents folder.
QString recordingFolder();
/// The error in a pattern, as a sentence; empty if the pattern is valid.
QString patternProblem(const QString& pattern);
/// The path of a new file: {date}, {time} and {robot} in the pattern are replaced, and {number} is the next
/// number after those of the existing files. Never returns the path of an existing file.
QString recordingPath(const RecordingChoice& choice, const QString& robot, const QDateTime& now);

}  // namespace tiller
