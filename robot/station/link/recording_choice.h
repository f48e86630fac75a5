// SPDX-License-Identifier: MIT
#pragma once

// What a recording is to be like, as the operator chose it: where its file goes, what it is called, which signals it
// has and how many of the robot's packets become a row.

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

/// "csv", "mcap": the ending of the file's name, and what settings call it.
QString formatName(RecordingChoice::Format format);
/// CSV when there is none of that name.
RecordingChoice::Format formatByName(const QString& name);
/// What can be recorded from every robot.
QStringList recordableFields();
/// "Tiller" in the user's documents.
QString recordingFolder();
/// What is wrong with a pattern, as a sentence; empty when nothing is.
QString patternProblem(const QString& pattern);
/// The path of a new file: {date}, {time} and {robot} of the pattern are filled in, {number} counts on from the files
/// that are there. No file that exists is ever named.
QString recordingPath(const RecordingChoice& choice, const QString& robot, const QDateTime& now);

}  // namespace tiller
