// SPDX-License-Identifier: MIT
#include "robot/recording/recorder.h"

#include <QFileInfo>
#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>
#include <utility>

#include "robot/realtime/thread_priority.h"
#include "robot/receive/default_fields.h"
#include "robot/recording/detail/csv_writer.h"
#include "robot/recording/detail/recording_file.h"

namespace tiller::recording {

namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

// Rows go to the system this often, which is what a killed process can lose, ...
constexpr milliseconds kWriteEvery{100};
// ... and from there to the disk this often, which is what a power failure can.
constexpr milliseconds kSyncEvery{500};
constexpr milliseconds kLookAtDiskEvery{1000};
constexpr std::size_t kWriteAtBytes = 256 * 1024;

std::int64_t freeBytesFor(const QString& path) {
    // Not QStorageInfo: it knows nothing of a place whose mount is not listed, as in a chroot or a container.
    std::error_code failed;
    const auto space = std::filesystem::space(QFileInfo(path).absolutePath().toStdString(), failed);
    return failed ? 0 : static_cast<std::int64_t>(space.available);
}

/// A sentence for each field that cannot be recorded.
QStringList notFollowed(const std::vector<std::string>& fields, const receive::SampleLayout& layout) {
    QStringList sentences = receive::unknownOutputs(fields);
    for (const std::string& field : fields) {
        if (layout.find(field) == nullptr && receive::unknownOutputs({field}).isEmpty()) {
            sentences
                << QStringLiteral("the receiver does not follow \"%1\"").arg(QString::fromStdString(field));
        }
    }
    return sentences;
}

}  // namespace

std::vector<std::string> defaultRecordedFields() {
    return receive::commonFields();
}

struct Recorder::Worker {
    std::thread thread;
    std::mutex mutex;  // for the two below and for waiting
    std::condition_variable wake;
    bool stopping = false;
    Error error;
    QString path;

    std::atomic<RecorderState> state{RecorderState::Idle};
    std::atomic<std::uint64_t> rows{0};
    std::atomic<std::uint64_t> lost{0};
    std::atomic<std::int64_t> durationNs{0};
    std::atomic<std::int64_t> bytes{0};
    std::atomic<std::int64_t> freeBytes{0};

    // The thread's own while it runs.
    std::unique_ptr<RecordingFile> file;
    std::unique_ptr<CsvWriter> writer;
    receive::Subscription subscription;
    receive::Sample sample;
    std::string text;  ///< whole rows not written yet
    std::uint64_t rowsInText = 0;
    std::uint64_t lostInText = 0;
    std::uint64_t every = 1;
    std::uint64_t lastSequence = 0;
    std::uint64_t dueSequence = 0;  ///< of the next row
    std::uint64_t missingBefore = 0;
    std::int64_t firstNs = 0;
    std::int64_t lastNs = 0;

    /// Writes what is in `text`. On failure the file is cut back to its last whole row.
    Result<void> flush() {
        if (text.empty()) {
            return {};
        }
        std::size_t got = 0;
        const Result<void> written = file->write(text, got);
        if (!written) {
            // Whole rows of a part that did get through are worth keeping.
            const std::size_t lineEnd = got == 0 ? std::string::npos : text.rfind('\n', got - 1);
            const std::size_t kept = lineEnd == std::string::npos ? 0 : lineEnd + 1;
            bytes += static_cast<std::int64_t>(kept);
            rows += static_cast<std::uint64_t>(
                std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(kept), '\n'));
            file->cut(bytes);
            text.clear();
            return written;
        }
        bytes += static_cast<std::int64_t>(got);
        rows += rowsInText;
        lost += lostInText;
        durationNs = lastNs - firstNs;
        text.clear();
        rowsInText = 0;
        lostInText = 0;
        return {};
    }

    void takeSample() {
        const std::uint64_t overrun = lastSequence == 0 ? 0 : sample.sequence - lastSequence - 1;
        const std::uint64_t missing = lastSequence == 0 ? 0 : overrun + sample.lostBefore;
        if (lastSequence == 0) {
            firstNs = sample.hostTimeNs;
        }
        lastSequence = sample.sequence;
        missingBefore += missing;
        if (sample.sequence < dueSequence) {
            return;
        }
        dueSequence = sample.sequence + every;
        lastNs = sample.hostTimeNs;
        writer->append(text, sample, missingBefore);
        ++rowsInText;
        lostInText += std::exchange(missingBefore, 0);
    }

    Result<void> drain() {
        while (subscription.next(sample)) {
            takeSample();
            if (text.size() >= kWriteAtBytes) {
                if (auto written = flush(); !written) {
                    return written;
                }
            }
        }
        return flush();
    }

    void run() {
        realtime::nameThread("tiller-record");
        auto syncDue = steady_clock::now() + kSyncEvery;
        auto lookDue = steady_clock::now() + kLookAtDiskEvery;
        for (;;) {
            bool last = false;
            {
                std::unique_lock lock(mutex);
                last = wake.wait_for(lock, kWriteEvery, [&] { return stopping; });
            }
            Result<void> result = drain();
            const auto now = steady_clock::now();
            if (result && (now >= syncDue || last)) {
                // Bytes that were taken may be lost only now, or only at the close.
                result = file->sync();
                syncDue = now + kSyncEvery;
            }
            if (last || !result) {
                const Result<void> closed = file->close();
                freeBytes = freeBytesFor(path);
                end(result ? closed : result);
                return;
            }
            if (now >= lookDue) {
                freeBytes = freeBytesFor(path);
                lookDue = now + kLookAtDiskEvery;
            }
        }
    }

    void end(const Result<void>& result) {
        const std::lock_guard lock(mutex);
        error = result.error();
        state = result ? RecorderState::Finished : RecorderState::Failed;
    }
};

Recorder::Recorder() : Recorder(systemFile) {}

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
    if (worker()->state == RecorderState::Recording) {
        return Error{
            ErrorCode::InvalidArgument, QStringLiteral("a recording is under way to %1").arg(path()), {}};
    }
    stop();  // what is left of a failed one
    auto next = std::make_shared<Worker>();
    next->path = options.path;
    if (options.every < 1) {
        return Error{ErrorCode::InvalidArgument,
                     QStringLiteral("a row every %1 packages; 1 or more").arg(options.every),
                     {}};
    }
    next->every = static_cast<std::uint64_t>(options.every);
    if (const QStringList missing = notFollowed(options.fields, *layout); !missing.isEmpty()) {
        return Error{ErrorCode::FieldUnknown,
                     QStringLiteral("record to %1").arg(QDir::toNativeSeparators(options.path)),
                     missing.join(QStringLiteral("; "))};
    }
    next->writer = std::make_unique<CsvWriter>(
        *layout, options.fields.empty() ? defaultRecordedFields() : options.fields, options.asGiven);
    if (next->writer->columns() == 0) {
        return Error{ErrorCode::InvalidArgument, QStringLiteral("no field to record"), {}};
    }
    next->file = files_();
    if (auto opened = next->file->open(options.path); !opened) {
        return opened;
    }
    next->text = next->writer->header();
    if (auto written = next->flush(); !written) {
        return written;
    }
    next->sample = receive::Sample(std::move(layout));
    next->subscription = std::move(subscription);
    next->freeBytes = freeBytesFor(options.path);
    next->state = RecorderState::Recording;
    next->thread = std::thread([recording = next.get()] { recording->run(); });
    const std::lock_guard lock(mutex_);
    d_ = std::move(next);
    return {};
}

void Recorder::stop() {
    const auto current = worker();
    if (!current->thread.joinable()) {
        return;
    }
    {
        const std::lock_guard lock(current->mutex);
        current->stopping = true;
    }
    current->wake.notify_all();
    current->thread.join();
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
    return progress;
}

Error Recorder::error() const {
    const auto current = worker();
    const std::lock_guard lock(current->mutex);
    return current->error;
}

QString Recorder::path() const {
    return worker()->path;
}

}  // namespace tiller::recording
