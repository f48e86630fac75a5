// SPDX-License-Identifier: MIT
#include "robot/recording/formats/recording_overview.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <array>

#include "robot/recording/formats/file_formats.h"
#include "robot/recording/formats/open_recording.h"

namespace tiller::recording {

namespace {

constexpr std::uint64_t kThumbnailBlocks = 60;
constexpr std::uint64_t kMaxRowsToRead = 200'000;
constexpr std::int64_t kNsPerMillisecond = 1'000'000;

/// The column that the overview shows as a curve; empty if there is none.
std::optional<std::size_t> shownColumn(const Recording& file) {
    for (const char* name : {"actual_TCP_force_2", "actual_current_0", "actual_q_0"}) {
        if (const auto column = file.indexOf(name)) {
            return column;
        }
    }
    const std::vector<RecordedColumn>& columns = file.columns();
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (!columns[i].whole && i != file.timeColumn()) {
            return i;
        }
    }
    return std::nullopt;
}

void addThumbnail(const Recording& file, RecordingOverview& overview) {
    const auto column = shownColumn(file);
    if (!column || file.rows() == 0 || (file.rows() > kMaxRowsToRead && file.summaryRows().empty())) {
        return;
    }
    const std::array<std::size_t, 1> wanted{*column};
    auto summaries = file.summaries(wanted, {0, file.rows()}, kThumbnailBlocks);
    if (summaries && !summaries->empty()) {
        overview.signal = QString::fromStdString(file.columns()[*column].name);
        overview.low = std::move(summaries->front().min);
        overview.high = std::move(summaries->front().max);
    }
}

}  // namespace

QString RecordingOverview::metadataText() const {
    QStringList parts;
    for (const auto& [name, value] : facts) {
        if (!isReservedMetadataName(name)) {
            parts << QStringLiteral("%1=%2").arg(QString::fromStdString(name), QString::fromStdString(value));
        }
    }
    return parts.join(QStringLiteral(", "));
}

bool RecordingOverview::matches(const QString& words) const {
    QStringList texts{QFileInfo(path).fileName(), start.toLocalTime().toString(Qt::ISODate)};
    texts << notes;
    for (const auto& [name, value] : facts) {
        texts << QStringLiteral("%1=%2").arg(QString::fromStdString(name), QString::fromStdString(value));
    }
    const QString all = texts.join(QLatin1Char('\n'));
    const QStringList wanted = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    return std::all_of(wanted.begin(), wanted.end(),
                       [&](const QString& word) { return all.contains(word, Qt::CaseInsensitive); });
}

Result<RecordingOverview> recordingOverview(const Text& path) {
    const auto opened = openRecording(path);
    if (!opened) {
        return opened.error();
    }
    const Recording& file = **opened;
    const QFileInfo info{QString(path)};
    RecordingOverview overview;
    overview.path = path;
    overview.format = file.format();
    overview.rows = file.rows();
    overview.bytes = info.size();
    overview.facts = file.facts();
    const auto start = file.startUtcNs();
    overview.start = start ? QDateTime::fromMSecsSinceEpoch(*start / kNsPerMillisecond) : info.lastModified();
    if (file.rows() > 0) {
        const auto last = file.times({file.rows() - 1, 1});
        if (!last) {
            return last.error();
        }
        overview.seconds = last->empty() ? 0 : last->front();
    }
    for (const RecordedEvent& event : file.events()) {
        if (event.source == QLatin1String(kNoteSource) || event.source == QLatin1String(kTriggerSource)) {
            overview.notes << event.text;
        }
    }
    addThumbnail(file, overview);
    return overview;
}

QStringList recordingsIn(const QString& folder) {
    QStringList filters;
    for (const FileFormat& format : fileFormats()) {
        for (const QString& suffix : format.suffixes) {
            filters << QStringLiteral("*.") + suffix;
        }
    }
    const QFileInfoList files = QDir(folder).entryInfoList(filters, QDir::Files | QDir::Readable, QDir::Time);
    QStringList paths;
    for (const QFileInfo& file : files) {
        if (!file.fileName().endsWith(QLatin1String(".notes.csv"))) {
            paths << file.filePath();
        }
    }
    return paths;
}

}  // namespace tiller::recording
