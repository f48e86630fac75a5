// SPDX-License-Identifier: MIT
#include "robot/recording/recorder.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

#include "robot/realtime/thread_priority.h"
#include "robot/receive/default_fields.h"
#include "robot/recording/csv_writer.h"

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

void syncToDisk(const QFile& file) {
#ifdef _WIN32
    _commit(file.handle());
#elif defined(__APPLE__)
    ::fsync(file.handle());
#else
    ::fdatasync(file.handle());
#endif
}

std::int64_t freeBytesFor(const QString& path) {
    // Not QStorageInfo: it knows nothing of a place whose mount is not listed, as in a chroot or a container.
    std::error_code failed;
    const auto space = std::filesystem::space(QFileInfo(path).absolutePath().toStdString(), failed);
    return failed ? 0 : static_cast<std::int64_t>(space.available);
}

Error fileError(const QFile& file, int systemError) {
    const bool full = systemError == ENOSPC || systemError == EDQUOT;
    return {full ? ErrorCode::DiskFull : ErrorCode::FileNotWritable,
            QStringLiteral("record to %1").arg(QDir::toNativeSeparators(file.fileName())),
            file.errorString()};
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
    std::unique_ptr<QFile> file;
    std::unique_ptr<CsvWriter> writer;
    receive::Subscription subscription;
    receive::Sample sample;
    std::string text;  ///< whole rows not written yet
    std::uint64_t rowsInText = 0;
    std::uint64_t lostInText = 0;
    std::uint64_t lastSequence = 0;
    std::int64_t firstNs = 0;
    std::int64_t lastNs = 0;

    /// Writes what is in `text`. On failure the file is cut back to its last whole row.
    Result<void> flush() {
        if (text.empty()) {
            return {};
        }
        errno = 0;
        const qint64 written = file->write(text.data(), static_cast<qint64>(text.size()));
        const int systemError = errno;
        if (written == static_cast<qint64>(text.size())) {
            bytes += written;
            rows += rowsInText;
            lost += lostInText;
            durationNs = lastNs - firstNs;
        } else {
            // Whole rows of a part that did get through are worth keeping.
            const auto got = static_cast<std::size_t>(std::max<qint64>(written, 0));
            const std::size_t lineEnd = got == 0 ? std::string::npos : text.rfind('\n', got - 1);
            const std::size_t kept = lineEnd == std::string::npos ? 0 : lineEnd + 1;
            const Error failure = fileError(*file, systemError);
            bytes += static_cast<std::int64_t>(kept);
            rows += static_cast<std::uint64_t>(
                std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(kept), '\n'));
            file->resize(bytes);
            text.clear();
            return failure;
        }
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
        lastNs = sample.hostTimeNs;
        writer->append(text, sample, missing);
        ++rowsInText;
        lostInText += missing;
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
            if (auto drained = drain(); !drained) {
                const std::lock_guard lock(mutex);
                error = drained.error();
                state = RecorderState::Failed;
                break;
            }
            const auto now = steady_clock::now();
            if (now >= syncDue || last) {
                syncToDisk(*file);
                syncDue = now + kSyncEvery;
            }
            if (now >= lookDue) {
                freeBytes = freeBytesFor(path);
                lookDue = now + kLookAtDiskEvery;
            }
            if (last) {
                state = RecorderState::Finished;
                break;
            }
        }
        file->close();
        freeBytes = freeBytesFor(path);
    }
};

Recorder::Recorder() : d_(std::make_shared<Worker>()) {}

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
    next->file = std::make_unique<QFile>(options.path);
    errno = 0;
    if (!next->file->open(QIODevice::WriteOnly | QIODevice::Truncate | QIODevice::Unbuffered)) {
        return fileError(*next->file, errno);
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
