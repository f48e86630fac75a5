// SPDX-License-Identifier: MIT
#pragma once

// Recording settings of the operator: folder, file name, recorded signals, the number of packets per row,
// metadata, trigger and maximum size of a file.

#include <QDateTime>
#include <QString>
#include <QStringList>

#include "robot/recording/formats/file_formats.h"

namespace tiller {

struct RecordingChoice {
    QString folder{};                        ///< empty: recordingFolder()
    QString pattern = defaultPattern();      ///< file name pattern; see recordingPath()
    QStringList fields{};                    ///< RTDE names; empty: all of recordableFields()
    int every = 1;                           ///< every n-th packet becomes a row
    QString format = QStringLiteral("csv");  ///< suffix of a row of recording::fileFormats()
    int keepFree = 200;                      ///< minimum free disk space; recording stops below it [MB]
    /// Fields of the metadata form as "name=value", in the order of the form. A field without a value is not
    /// recorded.
    QStringList metadata = defaultMetadata();
    bool asksMetadata = false;  ///< show the metadata form before each recording
    QString trigger{};          ///< see RecordingTrigger::parse(); empty: recording starts at once
    double before = 2;          ///< recorded time before the trigger [s]
    double after = 2;           ///< recorded time after the trigger [s]
    int fileMinutes = 0;        ///< maximum duration of a file [min]; 0: no limit
    int fileSize = 0;           ///< size after which a new file begins [MB]; 0: no limit

    static constexpr int kMaxDecimation = 500;
    static constexpr int kMaxKeptFree = 100'000;  ///< [MB]
    static constexpr qsizetype kMaxMetadata = 50;
    static constexpr double kMaxBefore = 60;   ///< [s]
    static constexpr double kMaxAfter = 3600;  ///< [s]
    static constexpr int kMaxFileMinutes = 10'000;
    static constexpr int kMaxFileSize = 1'000'000;  ///< [MB]
    /// Operator, experiment and sample, without values.
    static QStringList defaultMetadata();
    static QString defaultPattern() { return QStringLiteral("{date}_{time}"); }

    /// Returns the settings with invalid values replaced by the nearest valid values.
    RecordingChoice sane() const;
    /// The fields with a value.
    recording::Metadata facts() const;

    friend bool operator==(const RecordingChoice&, const RecordingChoice&) = default;
};

/// Returns the file format with this suffix; CSV for a suffix that a recorder cannot write.
const recording::FileFormat& recordingFormat(const QString& suffix);

/// Translated words for a format that a recorder can write.
struct RecordingFormatWords {
    QString choice;      ///< text in a list of formats
    QString button;      ///< accessible name of the button that starts a recording
    QString buttonHint;  ///< tooltip of the button
};
RecordingFormatWords recordingFormatWords(const recording::FileFormat& format);
/// Fields that every robot can record.
QStringList recordableFields();
/// The folder "Tiller" in the user's documents folder.
QString recordingFolder();
/// The error in a pattern, as a sentence; empty if the pattern is valid.
QString patternProblem(const QString& pattern);
/// The error in a trigger, as a sentence; empty if the trigger is valid or empty.
QString triggerProblem(const QString& trigger);
/// RTDE names of the fields that a trigger needs.
QStringList triggerFields(const QString& trigger);
/// The path of a new file. {date}, {time} and {robot} in the pattern are replaced; {number} is one more than
/// the highest number of the existing files. Never returns the path of an existing file.
QString recordingPath(const RecordingChoice& choice, const QString& robot, const QDateTime& now);

}  // namespace tiller
