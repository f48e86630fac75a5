// SPDX-License-Identifier: MIT
#include "robot/recording/detail/csv_notes.h"

#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <utility>

#include "robot/core/file_reading.h"

namespace tiller::recording {

namespace {

constexpr qint64 kNsPerMs = 1'000'000;
constexpr char kHeader[] = "row,utc,level,source,text\n";
// A longer file was not written by a recorder.
constexpr qint64 kMaxBytes = 64 << 20;

QString quoted(QString text) {
    text.replace(QLatin1Char('\r'), QLatin1Char(' ')).replace(QLatin1Char('\n'), QLatin1Char(' '));
    return QLatin1Char('"') + text.replace(QLatin1Char('"'), QLatin1String("\"\"")) + QLatin1Char('"');
}

/// Splits at commas outside quotes.
QStringList cellsOf(const QString& line) {
    QStringList cells(QString{});
    bool inQuotes = false;
    for (qsizetype i = 0; i < line.size(); ++i) {
        const QChar each = line[i];
        if (each == QLatin1Char('"')) {
            if (inQuotes && i + 1 < line.size() && line[i + 1] == QLatin1Char('"')) {
                cells.back() += line[++i];
            } else {
                inQuotes = !inQuotes;
            }
        } else if (each == QLatin1Char(',') && !inQuotes) {
            cells << QString();
        } else {
            cells.back() += each;
        }
    }
    return cells;
}

/// Removes the line ending, which is CR LF in files of spreadsheet programs.
QByteArray lineOf(QFile& file) {
    QByteArray line = file.readLine();
    while (line.endsWith('\n') || line.endsWith('\r')) {
        line.chop(1);
    }
    return line;
}

bool hasHeader(QFile& file) {
    QByteArray line = lineOf(file);
    if (line.startsWith("\xEF\xBB\xBF")) {
        line.remove(0, 3);
    }
    return line + '\n' == kHeader;
}

}  // namespace

bool isCsvNote(int level, const QString& source) {
    constexpr int kWarning = 30;
    return level >= kWarning || source == QLatin1String(kNoteSource) ||
           source == QLatin1String(kStepSource) || source == QLatin1String(kTriggerSource);
}

QString csvNotesPath(const QString& recording) {
    const QFileInfo file(recording);
    return file.path() + QLatin1Char('/') + file.completeBaseName() + QStringLiteral(".notes.csv");
}

Result<void> removeCsvNotes(const QString& recording) {
    const QString path = csvNotesPath(recording);
    QFile file;
    if (!QFileInfo::exists(path)) {
        return {};
    }
    if (!openForReading(file, path) || !hasHeader(file)) {
        return Error{ErrorCode::FileNotWritable, path,
                     QStringLiteral("the file does not contain notes of a recording; rename the file")};
    }
    file.close();
    return QFile::remove(path) ? Result<void>()
                               : Result<void>(Error{ErrorCode::FileNotWritable, path, QString()});
}

std::string csvNotesHeader() {
    return kHeader;
}

std::string csvNoteLine(std::uint64_t row, const RecordedNote& note) {
    const QString utc =
        note.utcNs == 0
            ? QString()
            : QDateTime::fromMSecsSinceEpoch(note.utcNs / kNsPerMs, Qt::UTC).toString(Qt::ISODateWithMs);
    return QStringLiteral("%1,%2,%3,%4,%5\n")
        .arg(QString::number(row), utc, QString::number(note.level), quoted(note.source), quoted(note.text))
        .toStdString();
}

std::vector<std::pair<std::uint64_t, RecordedEvent>> readCsvNotes(const QString& recording) {
    QFile file;
    const QString path = csvNotesPath(recording);
    if (!QFileInfo::exists(path) || !openForReading(file, path) || file.size() > kMaxBytes ||
        !hasHeader(file)) {
        return {};
    }
    std::vector<std::pair<std::uint64_t, RecordedEvent>> notes;
    while (!file.atEnd()) {
        const QStringList cells = cellsOf(QString::fromUtf8(lineOf(file)));
        bool hasRow = false;
        bool hasLevel = false;
        const std::uint64_t row = cells.value(0).toULongLong(&hasRow);
        const int level = cells.value(2).toInt(&hasLevel);
        if (hasRow && hasLevel && cells.size() == 5) {
            notes.emplace_back(row, RecordedEvent{0, level, cells[3], cells[4]});
        }
    }
    return notes;
}

}  // namespace tiller::recording
