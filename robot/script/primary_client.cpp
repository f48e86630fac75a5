// SPDX-License-Identifier: MIT
#include "robot/script/primary_client.h"

#include <QTcpSocket>
#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>

#include "robot/script/detail/primary_listener.h"
#include "robot/script/tcp_socket.h"

namespace tiller::script {

using std::chrono::milliseconds;

namespace {

/// Limits the read rate to 100 times the 20 kB/s of a controller. Data beyond this rate remain in the TCP
/// buffers and slow down the sender, so that a flood of data does not occupy a whole CPU core.
class ReadPace {
public:
    void take(std::size_t bytes) { taken_ += bytes; }
    milliseconds pause() {
        const auto now = std::chrono::steady_clock::now();
        if (now >= end_) {
            end_ = now + kSlice;
            taken_ = 0;
        }
        return taken_ < kBytesPerSlice ? milliseconds::zero() : std::chrono::ceil<milliseconds>(end_ - now);
    }

private:
    static constexpr milliseconds kSlice{5};
    static constexpr std::size_t kBytesPerSlice = 10'000;  // 2 MB/s
    std::chrono::steady_clock::time_point end_{};
    std::size_t taken_ = 0;
};

}  // namespace

struct PrimaryClient::Private {
    PrimaryClientOptions options;

    std::atomic<bool> stopWanted{false};

    mutable std::mutex mutex;
    mutable std::condition_variable changed;
    ListenerThread thread{mutex, changed};
    // The following members are protected by the mutex.
    std::deque<ControllerMessage> messages;
    PrimaryState state;
    std::optional<RobotConfiguration> configuration;
    Error error;
    bool connected = false;
    bool running = false;
    std::uint64_t dropped = 0;
    std::uint64_t malformed = 0;

    void run();
    Error listen();
    void publish(PrimaryParser& parser);
    bool pauseFor(milliseconds time);
};

void PrimaryClient::Private::run() {
    std::size_t attempt = 0;
    while (!thread.cancel.isCancelled()) {
        const Error ended = listen();
        {
            const std::lock_guard lock(mutex);
            if (connected) {
                attempt = 0;
            }
            connected = false;
            error = ended;
        }
        changed.notify_all();
        if (!options.reconnect ||
            !pauseFor(kReconnectDelays[std::min(attempt++, kReconnectDelays.size() - 1)])) {
            break;
        }
    }
    const std::lock_guard lock(mutex);
    running = false;
    changed.notify_all();
}

// Returns the reason why the connection could not be opened or has ended.
Error PrimaryClient::Private::listen() {
    constexpr milliseconds kConnectTime(3000);
    auto socket = openTcpSocket(options.host, options.port, Deadline::after(kConnectTime, thread.cancel));
    if (!socket) {
        return socket.error();
    }
    {
        const std::lock_guard lock(mutex);
        connected = true;
        error = {};
        state = {};
    }
    const QString context = QStringLiteral("listen to %1:%2").arg(options.host).arg(options.port);
    const auto descriptor = static_cast<native_socket::Descriptor>((*socket)->socketDescriptor());
    PrimaryReader reader;
    ReadPace pace;
    std::uint64_t malformedBefore = 0;
    // Short compared with the 20 ms within which cancellation takes effect.
    constexpr milliseconds kPoll(5);
    while (!thread.cancel.isCancelled()) {
        if (stopWanted.exchange(false, std::memory_order_acq_rel)) {
            // The message fits into the send buffer of any working connection. Connection failures are
            // reported elsewhere.
            (void)sendStopProgram(descriptor);
        }
        const native_socket::Status status = reader.read(descriptor, kPoll, *options.clock);
        if (status == native_socket::Status::WouldBlock) {
            continue;
        }
        if (status != native_socket::Status::Ok) {
            return {
                status == native_socket::Status::Closed ? ErrorCode::ConnectionClosed : ErrorCode::LinkLost,
                context,
                {}};
        }
        PrimaryParser& parser = reader.parser();
        {
            const std::lock_guard lock(mutex);
            malformed += parser.malformed() - malformedBefore;
            malformedBefore = parser.malformed();
        }
        publish(parser);
        if (!reader.understands()) {
            return PrimaryReader::notUnderstood(context);
        }
        pace.take(reader.lastBytes());
        if (const milliseconds pause = pace.pause(); pause > milliseconds::zero()) {
            pauseFor(pause);
        }
    }
    return {ErrorCode::Cancelled, context, {}};
}

void PrimaryClient::Private::publish(PrimaryParser& parser) {
    const std::lock_guard lock(mutex);
    for (ControllerMessage& message : parser.takeMessages()) {
        if (messages.size() >= options.maxMessages) {
            messages.pop_front();
            ++dropped;
        }
        messages.push_back(std::move(message));
    }
    state = parser.state();
    if (parser.configuration()) {
        configuration = parser.configuration();
    }
    changed.notify_all();
}

// Returns false if interrupted by stop().
bool PrimaryClient::Private::pauseFor(milliseconds time) {
    std::unique_lock lock(mutex);
    return !changed.wait_for(lock, time, [this] { return thread.cancel.isCancelled(); });
}

PrimaryClient::PrimaryClient(const PrimaryClientOptions& options) : d_(std::make_unique<Private>()) {
    d_->options = options;
}

PrimaryClient::~PrimaryClient() {
    stop();
}

void PrimaryClient::start() {
    d_->thread.begin(
        [this] {
            d_->running = true;
            d_->error = {};
        },
        [d = d_.get()] { d->run(); });
}

void PrimaryClient::stop() {
    d_->thread.end();
}

Result<void> PrimaryClient::waitForState(const Deadline& deadline) const {
    std::unique_lock lock(d_->mutex);
    while (d_->state.packages == 0) {
        const bool ended = !d_->running;
        if (ended || deadline.hasExpired()) {
            if (d_->error.code != ErrorCode::None) {
                return d_->error;
            }
            return Error{deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout,
                         QStringLiteral("wait for the robot state from %1:%2")
                             .arg(d_->options.host)
                             .arg(d_->options.port),
                         {}};
        }
        d_->changed.wait_for(lock, std::max(deadline.nextPoll(), milliseconds(1)));
    }
    return {};
}

bool PrimaryClient::isConnected() const {
    const std::lock_guard lock(d_->mutex);
    return d_->connected;
}

Error PrimaryClient::connectionError() const {
    const std::lock_guard lock(d_->mutex);
    return d_->error;
}

void PrimaryClient::requestProgramStop() {
    d_->stopWanted.store(true, std::memory_order_release);
}

std::vector<ControllerMessage> PrimaryClient::takeMessages() {
    const std::lock_guard lock(d_->mutex);
    std::vector<ControllerMessage> taken(std::make_move_iterator(d_->messages.begin()),
                                         std::make_move_iterator(d_->messages.end()));
    d_->messages.clear();
    return taken;
}

PrimaryState PrimaryClient::state() const {
    const std::lock_guard lock(d_->mutex);
    return d_->state;
}

std::optional<RobotConfiguration> PrimaryClient::configuration() const {
    const std::lock_guard lock(d_->mutex);
    return d_->configuration;
}

std::uint64_t PrimaryClient::droppedMessages() const {
    const std::lock_guard lock(d_->mutex);
    return d_->dropped;
}

std::uint64_t PrimaryClient::malformedPackages() const {
    const std::lock_guard lock(d_->mutex);
    return d_->malformed;
}

}  // namespace tiller::script
