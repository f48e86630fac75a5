// SPDX-License-Identifier: MIT
#include "robot/publish/publisher.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <future>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "robot/platform/thread_priority.h"

namespace tiller::publish {

namespace {

using std::chrono::steady_clock;

/// After this time without work, a thread for turns that may block ends.
constexpr std::chrono::seconds kIdleTime{5};
/// If a turn has waited for this time, all threads for blocking turns are busy, and another thread is started.
constexpr std::chrono::milliseconds kBlockingTimeout{50};

enum class TurnEnd { Wait, AtOnce, Ended };

}  // namespace

struct Publication::Entry {
    explicit Entry(PublicationOptions options)
        : sink(std::move(options.sink))
        , subscription(std::move(options.subscription))
        , sample(std::move(options.layout))
        , every(options.every) {}

    std::shared_ptr<Publisher::Worker> worker;
    std::atomic<std::uint64_t> packets{0};
    std::atomic<std::uint64_t> missed{0};

    // Protected by the mutex of the worker.
    steady_clock::time_point due{};
    steady_clock::time_point handedOver{};
    bool isBusy = false;  ///< a turn is in progress or handed over
    bool isLast = false;
    bool hasEnded = false;

    // The following members are used by one thread at a time, in turns.
    std::shared_ptr<SampleSink> sink;  ///< null after the end
    receive::Subscription subscription;
    receive::Sample sample;
    const std::chrono::milliseconds every;
    std::optional<std::promise<Result<void>>> opening{std::in_place};
    std::uint64_t lastSequence = 0;

    TurnEnd runTurn(bool last) {
        if (opening) {
            Result<void> opened = sink->open();
            const bool ok = opened.ok();
            opening->set_value(std::move(opened));
            opening.reset();
            if (!ok) {
                return TurnEnd::Ended;
            }
        }
        sink->beginTurn();
        auto next = SampleSink::Next::Continue;
        while (next == SampleSink::Next::Continue && subscription.next(sample)) {
            const std::uint64_t overrun = lastSequence == 0 ? 0 : sample.sequence - lastSequence - 1;
            const std::uint64_t missing = lastSequence == 0 ? 0 : overrun + sample.lostBefore;
            lastSequence = sample.sequence;
            missed += overrun;
            next = sink->take(sample, missing);
            ++packets;
        }
        const bool again = next == SampleSink::Next::NewTurn;
        if (!sink->endTurn(last && !again) || next == SampleSink::Next::End || (last && !again)) {
            sink->close();
            return TurnEnd::Ended;
        }
        return again ? TurnEnd::AtOnce : TurnEnd::Wait;
    }

    /// Ends after an exception of the sink, so that the other sinks are not affected.
    void fail(const QString& text) {
        if (opening) {
            opening->set_value(Error{ErrorCode::Internal, QStringLiteral("publish samples"), text});
            opening.reset();
        } else {
            qWarning("An output for robot data failed: %s", qPrintable(text));
        }
    }
};

struct Publisher::Worker {
    using Entry = std::shared_ptr<Publication::Entry>;

    explicit Worker(Sinks kind) : sinks(kind) {}

    const Sinks sinks;
    std::mutex mutex;
    std::condition_variable changed;     ///< wakes the thread of the publisher
    std::condition_variable handedOver;  ///< wakes the threads in `others`
    std::condition_variable ended;       ///< wakes callers that wait for an end
    std::vector<Entry> entries;
    std::deque<Entry> blocking;  ///< turns that wait for a thread in `others`
    std::vector<std::thread> others;
    std::vector<std::thread::id> finished;  ///< threads in `others` that are ending
    std::size_t idle = 0;                   ///< number of threads in `others` that wait for a turn
    bool isEnding = false;
    std::thread thread;

    /// Runs a turn without the lock.
    void runTurn(const Entry& entry, std::unique_lock<std::mutex>& lock) {
        const bool last = entry->isLast;
        lock.unlock();
        TurnEnd end = TurnEnd::Ended;
        try {
            end = entry->runTurn(last);
        } catch (const std::exception& failure) {
            entry->fail(QString::fromUtf8(failure.what()));
        } catch (...) {
            entry->fail(QStringLiteral("unknown exception"));
        }
        if (end == TurnEnd::Ended) {
            entry->sink.reset();
        }
        lock.lock();
        entry->isBusy = false;
        entry->due =
            steady_clock::now() + (end == TurnEnd::Wait ? entry->every : std::chrono::milliseconds());
        if (end == TurnEnd::Ended) {
            std::erase(entries, entry);
            entry->hasEnded = true;
            ended.notify_all();
        }
    }

    /// Starts another thread if a turn has waited too long for one.
    /// Returns  when to check again; empty: not before the next change
    std::optional<steady_clock::time_point> relieve(steady_clock::time_point now) {
        if (blocking.empty()) {
            return std::nullopt;
        }
        if (others.empty() || now - blocking.front()->handedOver >= kBlockingTimeout) {
            blocking.front()->handedOver = now;
            try {
                others.emplace_back([this] { runOther(); });
            } catch (const std::system_error&) {
                // The system has no more threads. The turn waits for a thread in `others`, or for the next
                // attempt.
            }
        }
        return blocking.front()->handedOver + kBlockingTimeout;
    }

    /// The entry whose turn is due first; null if none is due yet. Sets `at` to the time of this turn, unless
    /// `at` is earlier.
    Entry nextDue(steady_clock::time_point now, std::optional<steady_clock::time_point>& at) const {
        Entry first;
        for (const Entry& entry : entries) {
            const steady_clock::time_point due = entry->isLast ? steady_clock::time_point() : entry->due;
            if (!entry->isBusy && (!at || due < *at)) {
                at = due;
                first = entry;
            }
        }
        return first && *at <= now ? first : nullptr;
    }

    void joinFinished(std::unique_lock<std::mutex>& lock) {
        std::vector<std::thread> done;
        for (const std::thread::id id : std::exchange(finished, {})) {
            const auto found = std::find_if(others.begin(), others.end(),
                                            [id](auto& other) { return other.get_id() == id; });
            done.push_back(std::move(*found));
            others.erase(found);
        }
        lock.unlock();
        for (std::thread& other : done) {
            other.join();
        }
        lock.lock();
    }

    void run() {
        realtime::nameThread("tiller-publish");
        std::unique_lock lock(mutex);
        while (!isEnding || !entries.empty()) {
            if (!finished.empty()) {
                joinFinished(lock);
            }
            const steady_clock::time_point now = steady_clock::now();
            std::optional<steady_clock::time_point> at = relieve(now);
            if (const Entry entry = nextDue(now, at)) {
                entry->isBusy = true;
                if (sinks == Sinks::Many && entry->sink->mayBlock()) {
                    entry->handedOver = now;
                    blocking.push_back(entry);
                    handedOver.notify_one();
                } else {
                    runTurn(entry, lock);
                }
            } else if (at) {
                changed.wait_until(lock, *at);
            } else {
                changed.wait(lock);
            }
        }
        lock.unlock();
        handedOver.notify_all();
        for (std::thread& other : others) {
            other.join();
        }
    }

    /// Runs turns that may block. Ends if another thread is idle too, or after kIdleTime without work.
    void runOther() {
        realtime::nameThread("tiller-files");
        std::unique_lock lock(mutex);
        do {
            ++idle;
            handedOver.wait_for(lock, kIdleTime,
                                [this] { return !blocking.empty() || (isEnding && entries.empty()); });
            --idle;
            if (blocking.empty()) {
                break;
            }
            const Entry entry = std::move(blocking.front());
            blocking.pop_front();
            runTurn(entry, lock);
            changed.notify_one();
        } while (idle == 0 || !blocking.empty());
        finished.push_back(std::this_thread::get_id());
        changed.notify_one();
    }
};

Publication& Publication::operator=(Publication&& other) noexcept {
    stop();
    entry_ = std::move(other.entry_);
    return *this;
}

void Publication::stop() {
    if (!entry_ || !entry_->worker) {
        return;
    }
    Publisher::Worker& worker = *entry_->worker;
    std::unique_lock lock(worker.mutex);
    entry_->isLast = true;
    worker.changed.notify_one();
    worker.ended.wait(lock, [this] { return entry_->hasEnded; });
}

std::uint64_t Publication::packets() const {
    return entry_ ? entry_->packets.load() : 0;
}

std::uint64_t Publication::missed() const {
    return entry_ ? entry_->missed.load() : 0;
}

Publisher::Publisher(Sinks sinks) : d_(std::make_shared<Worker>(sinks)) {}

Publisher::~Publisher() {
    {
        const std::lock_guard lock(d_->mutex);
        d_->isEnding = true;
        for (const auto& entry : d_->entries) {
            entry->isLast = true;
        }
    }
    d_->changed.notify_one();
    if (d_->thread.joinable()) {
        d_->thread.join();
    }
}

Result<Publication> Publisher::add(PublicationOptions options) {
    Publication publication;
    publication.entry_ = std::make_shared<Publication::Entry>(std::move(options));
    publication.entry_->worker = d_;
    std::future<Result<void>> opened = publication.entry_->opening->get_future();
    {
        const std::lock_guard lock(d_->mutex);
        d_->entries.push_back(publication.entry_);
        if (!d_->thread.joinable()) {
            d_->thread = std::thread([worker = d_.get()] { worker->run(); });
        }
    }
    d_->changed.notify_one();
    if (Result<void> result = opened.get(); !result) {
        return result.error();
    }
    return publication;
}

}  // namespace tiller::publish
