// SPDX-License-Identifier: MIT
#pragma once

// Recording settings of the operator: folder and name of the file, recorded signals, and the ratio of packets to
// rows.

#include <QDateTime>
#include <QString>
#include <QStringList>

namespace tiller {

struct RecordingChoice {
    enum class Format {
        Csv,   ///< a row a packet, for everything that reads text
        Mcap,  ///< every field with its type, the log and the project inside
    };
    QString folder{};                    ///< empty: recordingFolder()
    QString pattern = defaultPattern();  ///< of the file name; see recordingPath()
    QStringList fields{};                ///< by their RTDE names; empty: all of recordableFields()
    int every = 1;                       ///< every n-th packet becomes a row
    Format format = Format::Csv;
    int keepFree = 200;  ///< ends in order when less is free on the disk [MB]

    static constexpr int kMostSparse = 500;
    static constexpr int kMostKeptFree = 100'000;  ///< [MB]
    static QString defaultPattern() { return QStringLiteral("{date}_{time}"); }

    /// The nearest one that can be recorded.
    RecordingChoice sane() const;

    friend bool operator==(const RecordingChoice&, const RecordingChoice&) = default;
};

/// "csv", "mcap": the file name suffix, and the name in the settings.
QString formatName(RecordingChoice::Format format);
/// CSV for unknown names.
RecordingChoice::Format formatByName(const QString& name);
/// Fields that every robot can record.
QStringList recordableFields();
/// "Tiller" in the user's documents.
QString recordingFolder();
/// The error of a pattern, as a sentence; empty if it is valid.
QString patternProblem(const QString& pattern);
/// The path of a new file: {date}, {time} and {robot} of the pattern are replaced, {number} continues from the
/// existing files. Never the path of an existing file.
QString recordingPath(const RecordingChoice& choice, const QString& robot, const QDateTime& now);

}  // namespace tiller
