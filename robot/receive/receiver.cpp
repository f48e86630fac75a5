// SPDX-License-Identifier: MIT
#include "robot/receive/receiver.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>

#include "robot/realtime/cpu_latency.h"
#include "robot/realtime/realtime_report.h"
#include "robot/realtime/ring.h"
#include "robot/realtime/seqlock.h"
#include "robot/realtime/stream_watch.h"
#include "robot/realtime/wake_up.h"
#include "robot/receive/data_age.h"
#include "robot/rtde/connection.h"
#include "robot/rtde/fields.h"
#include "robot/rtde/values.h"

namespace tiller::receive {

namespace {

using std::chrono::milliseconds;

// A record consists of sequence number, host time, connection number, number of samples lost before it, and
// the bit patterns of the values.
constexpr std::size_t kSequence = 0;
constexpr std::size_t kHostTime = 1;
constexpr std::size_t kConnection = 2;
constexpr std::size_t kLostBefore = 3;
constexpr std::size_t kFirstValue = 4;
constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

// Maximum blocking time in the socket between two checks of the stop flag.
constexpr milliseconds kReadSlice{50};
constexpr std::int64_t kRateWindowNs = 500 * kNsPerMs;

void prepare(Sample& sample, const std::shared_ptr<const SampleLayout>& layout) {
    if (sample.layout != layout) {
        sample.layout = layout;
        sample.values.resize(layout->size());
    }
}

void putWord(Sample& sample, std::size_t index, std::uint64_t word) {
    switch (index) {
        case kSequence:
            sample.sequence = word;
            break;
        case kHostTime:
            sample.hostTimeNs = static_cast<std::int64_t>(word);
            break;
        case kConnection:
            sample.connection = word;
            break;
        case kLostBefore:
            sample.lostBefore = word;
            break;
        default:
            sample.values[index - kFirstValue] = std::bit_cast<double>(word);
    }
}

std::vector<std::string> withTimestamp(std::vector<std::string> fields) {
    if (std::find(fields.begin(), fields.end(), "timestamp") == fields.end()) {
        fields.insert(fields.begin(), "timestamp");
    }
    return fields;
}

Error noHost() {
    return {ErrorCode::InvalidArgument, QStringLiteral("start a receiver"),
            QStringLiteral("no host is specified")};
}

Error unknownFields(const std::vector<std::string>& fields) {
    const QStringList unknown = unknownOutputs(fields);
    return unknown.isEmpty() ? Error{}
                             : Error{ErrorCode::FieldUnknown, QStringLiteral("start a receiver"),
                                     unknown.join(QStringLiteral("; "))};
}

}  // namespace

struct Subscription::Stream {
    Stream(std::shared_ptr<const SampleLayout> l, std::size_t capacity)
        : layout(std::move(l)), ring(kFirstValue + layout->size(), capacity) {}

    std::shared_ptr<const SampleLayout> layout;
    realtime::BroadcastRing ring;
    std::atomic<bool> ended{true};  ///< the receiver is not running, so no more data will arrive
    mutable realtime::WakeUp wakeUp;
    mutable std::mutex factsMutex;  ///< never locked while data are received
    Error lastError;

    /// The error returned by a failed wait.
    Error failure(const Deadline& deadline, const QString& what) const {
        if (deadline.isCancelled()) {
            return {ErrorCode::Cancelled, what, {}};
        }
        const std::lock_guard lock(factsMutex);
        return {ErrorCode::Timeout, what,
                lastError.code == ErrorCode::None ? QStringLiteral("no data arrived in time")
                                                  : lastError.toString()};
    }
};

bool Subscription::next(Sample& sample) {
    if (!stream_) {
        return false;
    }
    prepare(sample, stream_->layout);
    return stream_->ring.popEach(cursor_,
                                 [&](std::size_t i, std::uint64_t word) { putWord(sample, i, word); });
}

Result<void> Subscription::next(Sample& sample, const Deadline& deadline) {
    const auto what = [] { return QStringLiteral("wait for the next sample"); };
    while (!next(sample)) {
        if (!stream_ || stream_->ended) {
            return Error{ErrorCode::NotConnected, what(), QStringLiteral("the receiver is not running")};
        }
        if (deadline.hasExpired()) {
            return stream_->failure(deadline, what());
        }
        stream_->wakeUp.wait(deadline.nextPoll(), [this] { return pending() > 0 || stream_->ended; });
    }
    return {};
}

Result<Sample> Subscription::next(const Deadline& deadline) {
    Sample sample;
    if (auto came = next(sample, deadline); !came) {
        return came.error();
    }
    return sample;
}

std::uint64_t Subscription::pending() const {
    return stream_ ? stream_->ring.pending(cursor_) : 0;
}

struct Receiver::Worker {
    explicit Worker(ReceiverOptions o)
        : options(std::move(o))
        , layout(std::make_shared<SampleLayout>(withTimestamp(options.fields)))
        , stream(std::make_shared<Subscription::Stream>(layout, options.ringCapacity)) {}

    // Set by the constructor.
    const ReceiverOptions options;
    const std::shared_ptr<const SampleLayout> layout;
    const std::shared_ptr<Subscription::Stream> stream;

    // Shared between the threads.
    std::thread thread;
    std::atomic<bool> stopping{false};
    CancelToken cancel;
    std::mutex waitMutex;
    std::condition_variable waitEnds;
    std::atomic<ReceiverState> state{ReceiverState::Stopped};
    std::atomic<std::uint16_t> localPort{0};
    native_socket::EventFd waker;  ///< ends the wait for a packet
    std::atomic<std::uint64_t> packets{0};
    std::atomic<std::uint64_t> late{0};
    std::atomic<std::uint64_t> lost{0};
    std::atomic<std::uint64_t> reconnects{0};
    std::atomic<double> rate{0};
    std::atomic<std::int64_t> jitter{0};
    std::atomic<std::int64_t> dueNs{0};  ///< expected arrival of the newest sample without delay
    std::atomic<bool> hasData{false};
    std::atomic<bool> receiving{false};  ///< the newest sample belongs to the current connection
    std::atomic<bool> resetWanted{false};
    realtime::Seqlock<realtime::Histogram> intervalsShown;
    mutable std::mutex factsMutex;  // never locked while data are received
    SoftwareVersion version;
    double period = 0;
    std::vector<std::string> absent;
    realtime::PriorityReport priority;

    // Only the receive thread uses the following members.
    std::vector<std::size_t> places;        ///< word index in the record for each number of a packet
    std::vector<std::size_t> absentPlaces;  ///< record words for which the packet has no number
    std::size_t timestampPlace = 0;
    std::uint64_t sequence = 0;
    std::uint64_t connections = 0;
    realtime::StreamWatch watch;
    realtime::Histogram intervals;
    std::int64_t previousHostNs = 0;
    bool hasPrevious = false;  ///< the current connection has delivered a packet before
    std::int64_t windowStartNs = 0;
    std::uint64_t windowPackets = 0;

    void run() {
        realtime::nameThread("tiller-receive");
        std::optional<realtime::CpuLatency> latency;
        if (options.priority > 0) {
            latency.emplace();
        }
        auto report = realtime::requestThreadPriority(options.priority);
        if (!options.cpus.empty()) {
            const QStringList said{report.advice, realtime::bindToCpus(options.cpus)};
            report.advice = said.join(QLatin1Char(' ')).trimmed();
        }
        {
            const std::lock_guard lock(factsMutex);
            priority = report;
        }
        std::size_t failures = 0;
        while (!stopping) {
            state = ReceiverState::Connecting;
            rtde::ConnectionOptions wanted;
            wanted.host = options.host;
            wanted.port = options.port;
            wanted.request.outputs = withTimestamp(options.fields);
            wanted.request.frequency = options.frequency;
            auto opened = rtde::Connection::open(wanted, Deadline::after(options.connectTimeout, cancel));
            const std::uint64_t before = sequence;
            Error failure = opened ? follow(**opened) : opened.error();
            localPort = 0;
            if (opened) {
                (*opened)->close();
            }
            if (stopping) {
                break;
            }
            // Only received data reset the retry delay. A peer that accepts and then closes connections is
            // retried at increasing intervals.
            failures = sequence != before ? 0 : failures;
            receiving = false;
            {
                const std::lock_guard lock(stream->factsMutex);
                stream->lastError = std::move(failure);
            }
            state = ReceiverState::Waiting;
            waitFor(delay(failures++));
        }
        state = ReceiverState::Stopped;
    }

    milliseconds delay(std::size_t failures) const {
        const auto& delays = options.reconnectDelays;
        return delays.empty() ? milliseconds(0) : delays[std::min(failures, delays.size() - 1)];
    }

    /// Waits by polling on the receiver's clock, which may run faster or slower than the system clock.
    void waitFor(milliseconds time) {
        constexpr milliseconds kAskEvery(5);
        const std::int64_t end = options.clock->nowNs() + time.count() * kNsPerMs;
        std::unique_lock lock(waitMutex);
        while (!stopping && options.clock->nowNs() < end) {
            waitEnds.wait_for(lock, kAskEvery, [&] { return stopping.load(); });
        }
    }

    /// Computes the record index of each number in the packet. The types reported by the robot are
    /// authoritative. If a type differs from the catalogue, only the numbers that fit are used.
    void plan(const rtde::Recipe& recipe) {
        places.assign(recipe.size(), kNowhere);
        std::vector<bool> isSent(layout->size());
        for (const rtde::RecipeField& field : recipe.fields()) {
            const SampleLayout::Entry* entry = layout->find(field.name);
            if (entry == nullptr) {
                continue;
            }
            const std::size_t count = std::min(entry->count, componentCount(field.type));
            for (std::size_t i = 0; i < count; ++i) {
                places[field.first + i] = kFirstValue + entry->first + i;
                isSent[entry->first + i] = true;
            }
        }
        absentPlaces.clear();
        for (std::size_t i = 0; i < isSent.size(); ++i) {
            if (!isSent[i]) {
                absentPlaces.push_back(kFirstValue + i);
            }
        }
        timestampPlace = kFirstValue + layout->find("timestamp")->first;
    }

    Error follow(rtde::Connection& connection) {
        plan(connection.outputs());
        {
            const std::scoped_lock lock(factsMutex, stream->factsMutex);
            stream->lastError = {};
            version = connection.version();
            period = connection.period();
            absent = connection.outputs().absent();
        }
        if (++connections > 1) {
            ++reconnects;
        }
        watch.begin(connection.period());
        const std::int64_t began = options.clock->nowNs();
        hasPrevious = false;
        windowStartNs = began;
        windowPackets = 0;
        localPort = native_socket::localPort(connection.descriptor());
        state = ReceiverState::Receiving;

        // From here to the return: no locks, no allocation, and no system calls except for the socket.
        std::int64_t heardNs = began;
        rtde::ByteView wire;
        while (!stopping) {
            switch (connection.readWire(wire, kReadSlice, &waker)) {
                case rtde::Connection::Read::Package:
                    heardNs = options.clock->nowNs();
                    publish(connection.outputs().layout(), wire, heardNs);
                    break;
                case rtde::Connection::Read::Nothing:
                    if (options.clock->nowNs() - heardNs > options.silenceLimit.count() * kNsPerMs) {
                        showIntervals();
                        return {ErrorCode::LinkLost, QStringLiteral("RTDE at %1").arg(connection.peer()),
                                QStringLiteral("no data for %1 ms").arg(options.silenceLimit.count())};
                    }
                    break;
                case rtde::Connection::Read::Closed:
                case rtde::Connection::Read::Failed:
                case rtde::Connection::Read::Malformed:
                    showIntervals();
                    return connection.error();
            }
        }
        showIntervals();
        return {};
    }

    /// Decodes the packet directly into the published record.
    realtime::StreamWatch::Verdict record(const rtde::ValueLayout& package, rtde::ByteView wire,
                                          std::int64_t hostNs) {
        realtime::StreamWatch::Verdict verdict;
        stream->ring.pushWith([&](realtime::BroadcastRing::Slot slot) {
            rtde::decodeEach(package, wire, [&](std::size_t i, double value) {
                if (places[i] != kNowhere) {
                    slot.set(places[i], std::bit_cast<std::uint64_t>(value));
                }
            });
            for (const std::size_t place : absentPlaces) {
                slot.set(place, std::bit_cast<std::uint64_t>(kAbsent));
            }
            verdict = watch.add(std::bit_cast<double>(slot.get(timestampPlace)), hostNs);
            slot.set(kSequence, ++sequence);
            slot.set(kHostTime, static_cast<std::uint64_t>(hostNs));
            slot.set(kConnection, connections);
            slot.set(kLostBefore, verdict.lost);
        });
        return verdict;
    }

    void publish(const rtde::ValueLayout& package, rtde::ByteView wire, std::int64_t hostNs) {
        if (resetWanted.load(std::memory_order_relaxed)) {
            resetWanted = false;
            reset();
        }
        // Publish the sample before updating the counters, so that a counted packet is always readable.
        const realtime::StreamWatch::Verdict verdict = record(package, wire, hostNs);
        if (hasPrevious) {
            lost.fetch_add(verdict.lost, std::memory_order_relaxed);
            late.fetch_add(verdict.late ? 1 : 0, std::memory_order_relaxed);
            intervals.add(hostNs - previousHostNs);
        }
        jitter.store(verdict.jitterNs, std::memory_order_relaxed);
        previousHostNs = hostNs;
        hasPrevious = true;
        dueNs.store(hostNs - std::max<std::int64_t>(verdict.jitterNs, 0), std::memory_order_release);
        hasData.store(true, std::memory_order_release);
        receiving.store(true, std::memory_order_release);
        packets.fetch_add(1, std::memory_order_release);
        stream->wakeUp.wake();

        ++windowPackets;
        if (hostNs - windowStartNs >= kRateWindowNs) {
            rate.store(static_cast<double>(windowPackets) * 1e9 / static_cast<double>(hostNs - windowStartNs),
                       std::memory_order_relaxed);
            windowStartNs = hostNs;
            windowPackets = 0;
            showIntervals();
        }
    }

    void showIntervals() { intervalsShown.store(intervals); }

    void reset() {
        packets = 0;
        late = 0;
        lost = 0;
        reconnects = 0;
        intervals.clear();
        showIntervals();
    }
};

Receiver::Receiver(ReceiverOptions options) : d_(std::make_unique<Worker>(std::move(options))) {}

Receiver::~Receiver() {
    stop();
}

Result<void> Receiver::start() {
    if (d_->thread.joinable()) {
        return {};
    }
    if (const Error wrong = d_->options.host.isEmpty() ? noHost() : unknownFields(d_->options.fields);
        wrong.code != ErrorCode::None) {
        const std::lock_guard lock(d_->stream->factsMutex);
        d_->stream->lastError = wrong;
        return wrong;
    }
    d_->receiving = false;
    d_->stream->ended = false;
    d_->stopping = false;
    d_->cancel = CancelToken();
    d_->state = ReceiverState::Connecting;
    d_->thread = std::thread([worker = d_.get()] { worker->run(); });
    return {};
}

void Receiver::stop() {
    if (!d_->thread.joinable()) {
        return;
    }
    {
        const std::lock_guard lock(d_->waitMutex);
        d_->stopping = true;
    }
    d_->cancel.cancel();
    d_->waitEnds.notify_all();
    d_->waker.wake();
    d_->thread.join();
    d_->waker.take();
    d_->stream->ended = true;
    d_->stream->wakeUp.wake();
}

ReceiverState Receiver::state() const {
    return d_->state;
}

std::uint16_t Receiver::localPort() const {
    return d_->localPort;
}

Error Receiver::lastError() const {
    const std::lock_guard lock(d_->stream->factsMutex);
    return d_->stream->lastError;
}

ReceiverCounters Receiver::counters() const {
    ReceiverCounters counters;
    counters.packets = d_->packets;
    counters.late = d_->late;
    counters.lost = d_->lost;
    counters.reconnects = d_->reconnects;
    counters.rateHz = ageNs() > 2 * kRateWindowNs ? 0.0 : d_->rate.load();
    counters.lastJitterNs = d_->jitter;
    return counters;
}

void Receiver::resetCounters() {
    d_->resetWanted = true;
}

realtime::Histogram Receiver::intervals() const {
    return d_->intervalsShown.load();
}

SoftwareVersion Receiver::version() const {
    const std::lock_guard lock(d_->factsMutex);
    return d_->version;
}

double Receiver::period() const {
    const std::lock_guard lock(d_->factsMutex);
    return d_->period;
}

std::vector<std::string> Receiver::absentFields() const {
    const std::lock_guard lock(d_->factsMutex);
    return d_->absent;
}

realtime::PriorityReport Receiver::priority() const {
    const std::lock_guard lock(d_->factsMutex);
    return d_->priority;
}

const std::shared_ptr<const SampleLayout>& Receiver::layout() const {
    return d_->layout;
}

Sample Receiver::latest() const {
    Sample sample;
    latest(sample);
    return sample;
}

void Receiver::latest(Sample& into) const {
    prepare(into, d_->layout);
    if (!d_->stream->ring.newest([&](std::size_t i, std::uint64_t word) { putWord(into, i, word); })) {
        into = Sample(d_->layout);
    }
}

Result<Sample> Receiver::waitForData(const Deadline& deadline, OnRefusal onRefusal) const {
    const auto what = [this] {
        return QStringLiteral("wait for data from %1:%2").arg(d_->options.host).arg(d_->options.port);
    };
    const auto isThere = [&] { return d_->receiving && isFresh(kMaxDataAge); };
    while (!isThere()) {
        if (state() == ReceiverState::Stopped) {
            return Error{ErrorCode::NotConnected, what(), QStringLiteral("start() was not called")};
        }
        if (deadline.hasExpired()) {
            const Error cause = lastError();
            return deadline.isCancelled() || cause.code == ErrorCode::None
                       ? d_->stream->failure(deadline, what())
                       : cause;
        }
        if (onRefusal == OnRefusal::Fail && !d_->hasData && state() == ReceiverState::Waiting) {
            const Error cause = lastError();
            if (cause.code == ErrorCode::ConnectionRefused || cause.code == ErrorCode::AddressInvalid) {
                return cause;
            }
        }
        d_->stream->wakeUp.wait(deadline.nextPoll(), isThere);
    }
    return latest();
}

std::int64_t Receiver::ageNs() const {
    if (!d_->hasData.load(std::memory_order_acquire)) {
        return std::numeric_limits<std::int64_t>::max();
    }
    return d_->options.clock->nowNs() - d_->dueNs.load(std::memory_order_acquire);
}

Subscription Receiver::subscribe() const {
    Subscription subscription;
    subscription.stream_ = d_->stream;
    subscription.cursor_ = d_->stream->ring.atEnd();
    return subscription;
}

}  // namespace tiller::receive
