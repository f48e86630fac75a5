// SPDX-License-Identifier: MIT
#include "robot/script/primary_client.h"

#include <QTcpSocket>
#include <algorithm>
#include <array>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <string_view>
#include <thread>

#include "robot/core/native_socket.h"
#include "robot/script/detail/primary_parser.h"
#include "robot/script/tcp_socket.h"

namespace tiller::script {

using std::chrono::milliseconds;

struct PrimaryClient::Private {
    PrimaryClientOptions options;

    std::thread thread;
    CancelToken cancel;
    std::atomic<bool> stopWanted{false};

    mutable std::mutex mutex;
    mutable std::condition_variable changed;
    // All below under the mutex.
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
    constexpr std::array<milliseconds, 4> kDelays{milliseconds(500), milliseconds(1000), milliseconds(2000),
                                                  milliseconds(5000)};
    std::size_t attempt = 0;
    while (!cancel.isCancelled()) {
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
        if (!options.reconnect || !pauseFor(kDelays[std::min(attempt++, kDelays.size() - 1)])) {
            break;
        }
    }
    const std::lock_guard lock(mutex);
    running = false;
    changed.notify_all();
}

// Returns why the connection could not be made, or ended.
Error PrimaryClient::Private::listen() {
    constexpr milliseconds kConnectTime(3000);
    auto socket = openTcpSocket(options.host, options.port, Deadline::after(kConnectTime, cancel));
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
    std::array<std::uint8_t, 8192> bytes;
    PrimaryParser parser;
    std::uint64_t malformedBefore = 0;
    // Short enough that the end of the thread is not felt in the 20 ms in which a cancel takes effect.
    constexpr milliseconds kPoll(5);
    while (!cancel.isCancelled()) {
        if (stopWanted.exchange(false, std::memory_order_acq_rel)) {
            static constexpr std::string_view kStop = "stop program\n";
            // What is so short fits whenever anything does; a connection that takes nothing is told of
            // elsewhere.
            (void)native_socket::send(descriptor,
                                      {reinterpret_cast<const std::uint8_t*>(kStop.data()), kStop.size()});
        }
        if (!native_socket::waitReadable(descriptor, kPoll)) {
            continue;
        }
        const auto got = native_socket::receive(descriptor, bytes);
        if (got.status == native_socket::Status::WouldBlock) {
            continue;
        }
        if (got.status != native_socket::Status::Ok) {
            return {got.status == native_socket::Status::Closed ? ErrorCode::ConnectionClosed
                                                                : ErrorCode::LinkLost,
                    context,
                    {}};
        }
        const bool understood = parser.feed(std::span(bytes).first(got.bytes), options.clock->nowNs());
        {
            const std::lock_guard lock(mutex);
            malformed += parser.malformed() - malformedBefore;
            malformedBefore = parser.malformed();
        }
        publish(parser);
        if (!understood) {
            return {ErrorCode::ProtocolError, context,
                    QStringLiteral("a package length that makes no sense")};
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

// False when it was cut short by stop().
bool PrimaryClient::Private::pauseFor(milliseconds time) {
    std::unique_lock lock(mutex);
    return !changed.wait_for(lock, time, [this] { return cancel.isCancelled(); });
}

PrimaryClient::PrimaryClient(const PrimaryClientOptions& options) : d_(std::make_unique<Private>()) {
    d_->options = options;
}

PrimaryClient::~PrimaryClient() {
    stop();
}

void PrimaryClient::start() {
    if (d_->thread.joinable()) {
        return;
    }
    {
        const std::lock_guard lock(d_->mutex);
        d_->running = true;
        d_->error = {};
    }
    d_->cancel = CancelToken();
    d_->thread = std::thread([this] { d_->run(); });
}

void PrimaryClient::stop() {
    if (!d_->thread.joinable()) {
        return;
    }
    {
        const std::lock_guard lock(d_->mutex);
        d_->cancel.cancel();
    }
    d_->changed.notify_all();
    d_->thread.join();
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
