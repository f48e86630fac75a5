// SPDX-License-Identifier: MIT
#include "robot/recording/recorder.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <atomic>
#include <deque>
#include <filesystem>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>

#include "robot/publish/publisher.h"
#include "robot/receive/default_fields.h"
#include "robot/receive/robot_state.h"
#include "robot/recording/detail/csv_notes.h"
#include "robot/recording/detail/packet_clock.h"
#include "robot/recording/detail/recording_file.h"
#include "robot/recording/detail/restart_note.h"
#include "robot/recording/detail/row_times.h"

namespace tiller::recording {

namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

// Interval for writing rows to the system. Limits the loss of data if the process is killed.
constexpr milliseconds kWriteEvery{100};
// Interval for syncing data to the disk. Limits the loss of data in a power failure.
constexpr milliseconds kSyncEvery{500};
constexpr milliseconds kLookAtDiskEvery{1000};
// Number of samples after which data are written: about 256 KB of text.
constexpr std::size_t kWriteAtSamples = 256;
constexpr int kInfoLevel = 20;  // as in rcl_interfaces/Log

/// Free space on the disk of this file; empty if the folder does not exist.
std::optional<std::int64_t> freeBytesFor(const QString& path) {
    // QStorageInfo does not find file systems whose mount point is not listed, e.g. in a chroot or a
    // container.
    std::error_code failed;
    const auto space = std::filesystem::space(QFileInfo(path).absolutePath().toStdString(), failed);
    return failed ? std::nullopt : std::optional(static_cast<std::int64_t>(space.available));
}

/// One sentence for each field that cannot be recorded.
QStringList notFollowed(const std::vector<std::string>& fields, const receive::SampleLayout& layout) {
    QStringList sentences = receive::unknownOutputs(fields);
    for (const std::string& field : fields) {
        if (layout.find(field) == nullptr && receive::unknownOutputs({field}).isEmpty()) {
            sentences << QStringLiteral("the receiver was started without the field \"%1\"")
                             .arg(QString::fromStdString(field));
        }
    }
    return sentences;
}

/// The fields in column order, without duplicates: `timestamp` first unless asGiven is set.
std::vector<std::string> orderedFields(const RecorderOptions& options, const receive::SampleLayout& layout) {
    std::vector<std::string> ordered;
    if (!options.asGiven) {
        ordered.emplace_back("timestamp");
    }
    std::vector<std::string> fields = options.fields;
    if (fields.empty()) {
        for (const auto& entry : layout.entries()) {
            fields.push_back(entry.name);
        }
    }
    for (const std::string& field : fields) {
        if (std::find(ordered.begin(), ordered.end(), field) == ordered.end()) {
            ordered.push_back(field);
        }
    }
    return ordered;
}

}  // namespace

std::vector<std::string> defaultRecordedFields() {
    return receive::commonFields();
}

struct Recorder::Worker : publish::SampleSink {
    std::mutex mutex;  // protects the following members
    Error error;
    QString path;
    Error notesError;
    std::vector<RecordedNote> notes;

    std::atomic<RecorderState> state{RecorderState::Idle};
    std::atomic<std::uint64_t> rows{0};
    std::atomic<std::uint64_t> lost{0};
    std::atomic<std::int64_t> durationNs{0};
    std::atomic<std::int64_t> bytes{0};
    std::atomic<std::int64_t> freeBytes{0};
    std::atomic<int> files{0};
    std::atomic<int> restarts{0};

    // The publisher uses the following members while the recording runs.
    RecorderOptions options;
    RecordingSetup setup;
    RecordingFileFactory makeFile;
    std::unique_ptr<RecordingFile> file;  ///< null: no open file
    std::unique_ptr<RecordingFile>
        notesFile;      ///< created for the first note if the format does not support notes
    RowTimes rowTimes;  ///< times of the rows in the open file
    std::unique_ptr<RecordingEncoder> encoder;
    std::optional<TriggerWatch> trigger;
    std::deque<std::pair<receive::Sample, std::uint64_t>>
        kept;                   ///< samples before a trigger, and the number of packets lost before each
    std::size_t unwritten = 0;  ///< samples since the last part
    std::uint64_t every = 1;
    double lastTime = -std::numeric_limits<double>::infinity();  ///< time stamp of the controller [s]
    std::uint64_t dueSequence = 0;                               ///< sequence number of the next row
    std::uint64_t missingBefore = 0;
    std::int64_t firstNs = 0;
    std::int64_t lastNs = 0;
    std::int64_t earlierNs = 0;  ///< duration of the closed files
    PacketClock clock;
    std::vector<RecordedNote> said;  ///< notes of the current turn
    Result<void> outcome;
    steady_clock::time_point syncDue{};
    steady_clock::time_point lookDue{};

    Result<void> openFile(const QString& to) {
        encoder = options.format->encoder(setup);
        if (!encoder) {
            return Error{ErrorCode::InvalidArgument, QStringLiteral("no field to record"), {}};
        }
        auto next = makeFile();
        if (auto opened = next->open(to); !opened) {
            return opened;
        }
        {
            const std::lock_guard lock(mutex);
            path = to;
            notesError = {};
        }
        file = std::move(next);
        if (!options.format->keepsNotes()) {
            noteFailed(removeCsvNotes(to));
        }
        rowTimes = {};
        bytes = 0;
        firstNs = lastNs = 0;
        ++files;
        const Result<void> written = write(RecordingEncoder::Close::WhenDue);
        if (!written && bytes == 0) {
            static_cast<void>(file->close());
            file.reset();
            // Remove an empty file, but not a device at this path.
            if (const QFileInfo left(to); left.isFile() && left.size() == 0) {
                QFile::remove(to);
            }
        }
        return written;
    }

    /// Writes the data available so far. After a failure, truncates the file to its last complete row.
    Result<void> write(RecordingEncoder::Close how) {
        unwritten = 0;
        const RecordedPart part = encoder->take(how);
        if (part.bytes.empty()) {
            return {};
        }
        std::size_t got = 0;
        const Result<void> written = file->write(part.bytes, got);
        if (!written) {
            // Keep the complete rows of a partially written part.
            std::uint64_t keptRows = 0;
            bytes += static_cast<std::int64_t>(
                encoder->keepOf(std::string_view(part.bytes).substr(0, got), keptRows));
            rows += keptRows;
            file->cut(bytes);
            return written;
        }
        bytes += static_cast<std::int64_t>(got);
        rows += part.rows;
        lost += part.lost;
        durationNs = earlierNs + lastNs - firstNs;
        return {};
    }

    Result<void> finishFile() {
        Result<void> result = write(RecordingEncoder::Close::Last);
        if (result) {
            result = file->sync();
        }
        const Result<void> closed = file->close();
        file.reset();
        if (notesFile) {
            noteFailed(notesFile->close());
            notesFile.reset();
        }
        earlierNs += lastNs - firstNs;
        if (result && closed && !QFileInfo::exists(path)) {
            return Error{ErrorCode::FileNotWritable, QDir::toNativeSeparators(path),
                         QStringLiteral("the recording is complete, but its file or folder was moved or "
                                        "renamed during the recording")};
        }
        return result ? closed : result;
    }

    bool isDivided() const { return options.fileSeconds > 0 || options.fileBytes > 0; }

    /// The path of the next numbered file. Files of an earlier run are kept.
    QString nextPath() const {
        int number = files + 1;
        while (QFileInfo::exists(numberedPath(options.path, number))) {
            ++number;
        }
        return numberedPath(options.path, number);
    }

    bool isFull(const receive::Sample& next) const {
        const bool isOld = options.fileSeconds > 0 &&
                           static_cast<double>(next.hostTimeNs - firstNs) >= options.fileSeconds * 1e9;
        const bool isLarge = options.fileBytes > 0 && bytes >= options.fileBytes;
        return firstNs != 0 && (isOld || isLarge);
    }

    Result<void> encode(const receive::Sample& row, std::uint64_t missing) {
        if (isFull(row)) {
            if (const auto finished = finishFile(); !finished) {
                return finished;
            }
            if (const auto opened = openFile(nextPath()); !opened) {
                return opened;
            }
        }
        firstNs = firstNs == 0 ? row.hostTimeNs : firstNs;
        lastNs = row.hostTimeNs;
        encoder->add(row, missing, clock.utcOf(row.hostTimeNs));
        ++unwritten;
        if (!options.format->keepsNotes()) {
            rowTimes.add(clock.utcOf(row.hostTimeNs), receive::RobotState(row).timestamp(), missing == 0);
        }
        return {};
    }

    Result<void> takeSample(const receive::Sample& sample, std::uint64_t missing) {
        missingBefore += missing;
        noteRestart(sample);
        if (trigger) {
            return takeTriggered(sample);
        }
        return encodeDue(sample);
    }

    /// The number of packets missed during a restart is unknown, so a restart is an event instead of a gap.
    void noteRestart(const receive::Sample& sample) {
        const double time = receive::RobotState(sample).timestamp();
        if (time < lastTime) {
            ++restarts;
            if (file) {
                encoder->add(RecordedNote{clock.utcOf(sample.hostTimeNs), kRestartLevel, kRestartSource,
                                          restartText(lastTime, time)});
            }
        }
        lastTime = time;
    }

    Result<void> takeTriggered(const receive::Sample& sample) {
        const TriggerWatch::Verdict verdict = trigger->add(sample);
        const std::uint64_t missing = std::exchange(missingBefore, 0);
        if (verdict == TriggerWatch::Verdict::End) {
            if (const auto finished = finishFile(); !finished) {
                return finished;
            }
            state = RecorderState::Waiting;
        }
        if (verdict == TriggerWatch::Verdict::Begin) {
            if (const auto opened = openFile(nextPath()); !opened) {
                return opened;
            }
            state = RecorderState::Recording;
            dueSequence = 0;
            for (const auto& [row, lostBefore] : std::exchange(kept, {})) {
                missingBefore += lostBefore;
                if (const auto encoded = encodeDue(row); !encoded) {
                    return encoded;
                }
            }
        }
        if (file) {
            missingBefore += missing;
            const auto encoded = encodeDue(sample);
            if (encoded && verdict == TriggerWatch::Verdict::Begin) {
                noteFailed(keepNote({clock.utcOf(sample.hostTimeNs), kInfoLevel, kTriggerSource,
                                     QStringLiteral("Trigger: %1").arg(trigger->cause())}));
            }
            return encoded;
        }
        kept.emplace_back(sample, missing);
        const auto spanNs = static_cast<std::int64_t>(options.trigger->before * 1e9);
        while (!kept.empty() && sample.hostTimeNs - kept.front().first.hostTimeNs > spanNs) {
            kept.pop_front();
        }
        return {};
    }

    Result<void> encodeDue(const receive::Sample& row) {
        if (row.sequence < dueSequence) {
            return {};
        }
        dueSequence = row.sequence + every;
        return encode(row, std::exchange(missingBefore, 0));
    }

    /// A failure to write notes does not end the recording, which is complete without them.
    void noteFailed(const Result<void>& result) {
        if (!result) {
            const std::lock_guard lock(mutex);
            notesError = result.error();
        }
    }

    Result<void> keepNote(const RecordedNote& note) {
        if (options.format->keepsNotes()) {
            encoder->add(note);
            return {};
        }
        if (notesError.code != ErrorCode::None || !isCsvNote(note.level, note.source)) {
            return {};
        }
        std::size_t written = 0;
        if (!notesFile) {
            auto next = makeFile();
            if (auto opened = next->open(csvNotesPath(path)); !opened) {
                return opened;
            }
            notesFile = std::move(next);
            if (auto headed = notesFile->write(csvNotesHeader(), written); !headed) {
                return headed;
            }
        }
        return notesFile->write(csvNoteLine(rowTimes.rowsBefore(note.utcNs), note), written);
    }

    bool mayBlock() const override { return true; }

    void beginTurn() override {
        const std::lock_guard lock(mutex);
        said.swap(notes);
    }

    Next take(const receive::Sample& sample, std::uint64_t missing) override {
        outcome = takeSample(sample, missing);
        if (outcome && file && unwritten >= kWriteAtSamples) {
            outcome = write(RecordingEncoder::Close::WhenDue);
        }
        return outcome && !isDone() ? Next::Continue : Next::End;
    }

    bool endTurn(bool last) override {
        if (outcome && file) {
            for (const RecordedNote& note : said) {
                noteFailed(keepNote(note));
            }
            outcome = write(RecordingEncoder::Close::WhenDue);
        }
        said.clear();
        last = last || isDone();
        const auto now = steady_clock::now();
        if (outcome && file && now >= lookDue && !last) {
            // If the folder was renamed, the file is still open and the recording continues.
            const std::optional<std::int64_t> left = freeBytesFor(options.path);
            freeBytes = left.value_or(freeBytes);
            lookDue = now + kLookAtDiskEvery;
            if (left && *left < options.keepFree) {
                outcome = finishFile();
                end(outcome ? noRoom() : outcome);
                return false;
            }
        }
        if (outcome && file && now >= syncDue && !last) {
            // Write errors may be reported only here or on closing.
            outcome = file->sync();
            syncDue = now + kSyncEvery;
        }
        if (!last && outcome) {
            return true;
        }
        if (outcome && file) {
            outcome = finishFile();
        } else if (file) {
            static_cast<void>(file->close());  // only the first error is reported
        }
        freeBytes = freeBytesFor(options.path).value_or(freeBytes);
        end(outcome);
        return false;
    }

    bool isDone() const {
        return trigger && !file && options.trigger->files > 0 && files >= options.trigger->files;
    }

    Result<void> noRoom() const {
        constexpr std::int64_t kMega = 1'000'000;
        return Error{
            ErrorCode::DiskFull, QDir::toNativeSeparators(path),
            QStringLiteral(
                "the recording was stopped and completed because less than %1 MB are free on the disk")
                .arg(options.keepFree / kMega)};
    }

    void end(const Result<void>& result) {
        const std::lock_guard lock(mutex);
        error = result.error();
        state = result ? RecorderState::Finished : RecorderState::Failed;
    }

    std::shared_ptr<publish::Publisher> publisher;
    publish::Publication publication;
};

Recorder::Recorder() : Recorder(systemFile) {}

Recorder::Recorder(std::shared_ptr<publish::Publisher> publisher) : Recorder(systemFile) {
    publisher_ = std::move(publisher);
}

Recorder::Recorder(RecordingFileFactory files) : files_(std::move(files)), d_(std::make_shared<Worker>()) {}

Recorder::~Recorder() {
    stop();
}

std::shared_ptr<Recorder::Worker> Recorder::worker() const {
    const std::lock_guard lock(mutex_);
    return d_;
}

Result<void> Recorder::start(const RecorderOptions& options, const receive::Receiver& receiver) {
    return start(options, receiver.subscribe(), receiver.layout());
}

Result<void> Recorder::start(const RecorderOptions& options, receive::Subscription subscription,
                             std::shared_ptr<const receive::SampleLayout> layout) {
    if (const RecorderState now = worker()->state;
        now == RecorderState::Recording || now == RecorderState::Waiting) {
        return Error{ErrorCode::InvalidArgument,
                     QStringLiteral("a recording to %1 is already running").arg(path()),
                     {}};
    }
    stop();  // closes the file of a failed recording
    auto next = std::make_shared<Worker>();
    next->path = options.path;
    if (options.every < 1) {
        return Error{ErrorCode::InvalidArgument,
                     QStringLiteral("one row every %1 packets: the minimum is 1").arg(options.every),
                     {}};
    }
    next->every = static_cast<std::uint64_t>(options.every);
    if (const QStringList missing = notFollowed(options.fields, *layout); !missing.isEmpty()) {
        return Error{ErrorCode::FieldUnknown, QDir::toNativeSeparators(options.path),
                     missing.join(QStringLiteral("; "))};
    }
    const QString suffix = QFileInfo(options.path).suffix().toLower();
    if (!options.format && (suffix == QLatin1String("mcap") || suffix == QLatin1String("h5") ||
                            suffix == QLatin1String("hdf5"))) {
        return Error{
            ErrorCode::InvalidArgument, QDir::toNativeSeparators(options.path),
            QStringLiteral("without RecorderOptions::format, the file would be CSV; set the format, for "
                           "example to formatForPath()")};
    }
    next->options = options;
    next->options.format = options.format ? options.format : csvFormat();
    next->setup = {layout, orderedFields(options, *layout), options.asGiven};
    next->makeFile = files_;
    next->state = options.trigger ? RecorderState::Waiting : RecorderState::Recording;
    if (options.trigger) {
        auto watch = TriggerWatch::make(*options.trigger, *layout);
        if (!watch) {
            return watch.error();
        }
        next->trigger = std::move(watch).value();
        if (!next->options.format->encoder(next->setup)) {
            return Error{ErrorCode::InvalidArgument, QStringLiteral("no field to record"), {}};
        }
    } else if (auto opened = next->openFile(next->isDivided() ? next->nextPath() : QString(options.path));
               !opened) {
        return opened;
    }
    next->freeBytes = freeBytesFor(options.path).value_or(0);
    next->syncDue = steady_clock::now() + kSyncEvery;
    next->lookDue = steady_clock::now() + kLookAtDiskEvery;
    next->publisher =
        publisher_ ? publisher_ : std::make_shared<publish::Publisher>(publish::Publisher::Sinks::One);
    next->publication =
        next->publisher->add({next, std::move(subscription), std::move(layout), kWriteEvery}).value();
    const std::lock_guard lock(mutex_);
    d_ = std::move(next);
    return {};
}

void Recorder::stop() {
    const auto current = worker();
    current->publication.stop();
    current->publisher.reset();
}

RecorderProgress Recorder::progress() const {
    const auto current = worker();
    RecorderProgress progress;
    progress.state = current->state;
    progress.rows = current->rows;
    progress.seconds = static_cast<double>(current->durationNs) / 1e9;
    progress.lost = current->lost;
    progress.bytes = current->bytes;
    progress.freeBytes = current->freeBytes;
    progress.files = current->files;
    progress.restarts = current->restarts;
    return progress;
}

Error Recorder::error() const {
    const auto current = worker();
    const std::lock_guard lock(current->mutex);
    return current->error;
}

Error Recorder::notesError() const {
    const auto current = worker();
    const std::lock_guard lock(current->mutex);
    return current->notesError;
}

QString Recorder::path() const {
    const auto current = worker();
    const std::lock_guard lock(current->mutex);
    return current->path;
}

void Recorder::note(const RecordedNote& note) {
    const auto current = worker();
    const std::lock_guard lock(current->mutex);
    constexpr std::size_t kMaxWaiting = 10'000;
    if (current->notes.size() < kMaxWaiting) {
        current->notes.push_back(note);
        current->notes.back().utcNs = current->clock.utcOfNote(note.utcNs);
    }
}

}  // namespace tiller::recording
