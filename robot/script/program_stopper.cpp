// SPDX-License-Identifier: MIT
#include "robot/script/program_stopper.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <utility>
#include <vector>

#include "robot/core/tcp_connect.h"
#include "robot/script/detail/primary_listener.h"

namespace tiller::script {

using native_socket::Descriptor;
using native_socket::Status;
using std::chrono::milliseconds;

namespace {

constexpr int kReadOnlySocket = 210;
constexpr std::int64_t kAskForNs = 2 * kNsPerSecond;
/// Interval between requests. A controller reports a stop within two robot states, which are 100 ms apart.
constexpr std::int64_t kAskAgainNs = 300 * kNsPerMs;
constexpr milliseconds kConnectTime(1000);
/// Time limit for opening the second connection of a stop. Meanwhile, the existing connection is not read.
constexpr milliseconds kSecondConnectTime(300);

}  // namespace

struct ProgramStopper::Private {
    ProgramStopperOptions options;

    mutable std::mutex mutex;
    mutable std::condition_variable changed;
    ListenerThread thread{mutex, changed};
    // The following members are protected by the mutex.
    bool running = false;
    Descriptor socket = -1;  ///< closed by the thread only
    bool renew = false;      ///< close this connection and open a new one
    bool discard = false;    ///< the request has ended without a stop
    Error connectionError;
    bool asked = false;
    bool sent = false;    ///< the request was sent on this connection
    bool second = false;  ///< open a second connection for the request
    int states = 0;       ///< robot states received since sending
    int refusals = 0;     ///< number of refusals since the request
    std::int64_t askedNs = 0;
    std::int64_t sentNs = 0;
    Error outcome;  ///< result of the last request; code None: stopped, or no request

    QString context() const {
        return QStringLiteral("stop the program at %1:%2").arg(options.host).arg(options.port);
    }
    std::int64_t now() const { return options.clock->nowNs(); }

    void run();
    Error listen(Descriptor descriptor);
    void use(Descriptor descriptor);
    bool wantsSecond();
    void send();
    void settle(Error how);
    void look();
    void hear(PrimaryParser& parser, std::uint64_t& packages);
    bool pauseFor(milliseconds time);
};

// All functions below require the mutex.

void ProgramStopper::Private::send() {
    if (socket < 0 || renew) {
        return;
    }
    const native_socket::Transfer out = sendStopProgram(socket);
    if (out.status != Status::Ok || out.bytes != kStopProgram.size()) {
        renew = true;  // the connection is broken or its buffer is full
        return;
    }
    sent = true;
    sentNs = now();
    states = 0;
}

void ProgramStopper::Private::settle(Error how) {
    asked = false;
    if (how.code != ErrorCode::None && how.code != ErrorCode::RemoteControlRequired) {
        discard = true;
        renew = renew || sent;
    }
    outcome = std::move(how);
    changed.notify_all();
}

void ProgramStopper::Private::look() {
    if (!asked) {
        return;
    }
    // The first refusal may concern a connection opened before the switch to Remote.
    constexpr int kRefusals = 2;
    if (refusals >= kRefusals) {
        settle({ErrorCode::RemoteControlRequired, context(),
                QStringLiteral("in Local control, the robot accepts neither programs nor stop commands from "
                               "this computer")});
    } else if (now() - askedNs > kAskForNs) {
        settle(connectionError.code != ErrorCode::None
                   ? connectionError
                   : Error{ErrorCode::Timeout, context(), QStringLiteral("the program is still running")});
    } else if (sent && now() - sentNs > kAskAgainNs) {
        renew = true;
    }
}

void ProgramStopper::Private::hear(PrimaryParser& parser, std::uint64_t& packages) {
    const bool waits = asked && sent && !renew;
    for (const ControllerMessage& message : parser.takeMessages()) {
        if (waits && !renew && message.kind == MessageKind::ErrorCode && message.code == kReadOnlySocket) {
            ++refusals;
            sent = false;  // the request was refused
            renew = true;
        }
    }
    const PrimaryState& state = parser.state();
    if (waits && !renew && state.packages != packages) {
        ++states;
        constexpr int kFresh = 2;  // the first state may have been sent before the stop
        if (states >= kFresh && !state.programRunning && !state.programPaused) {
            settle({});
        }
    }
    packages = state.packages;
}

// The following functions are called by the thread only.

void ProgramStopper::Private::run() {
    // Limits the rate of attempts if the peer closes every connection immediately.
    constexpr milliseconds kBrief(50);
    std::size_t attempt = 0;
    while (!thread.cancel.isCancelled()) {
        const auto opened =
            connectTcp(options.host, options.port, Deadline::after(kConnectTime, thread.cancel));
        const auto since = std::chrono::steady_clock::now();
        Error ended;
        if (opened) {
            attempt = 0;
            ended = listen(*opened);
        } else {
            ended = opened.error();
        }
        bool atOnce = false;
        {
            const std::lock_guard lock(mutex);
            atOnce = opened.ok() && std::exchange(renew, false) &&
                     std::chrono::steady_clock::now() - since > kBrief;
            connectionError = ended;
            look();
        }
        changed.notify_all();
        if (!atOnce) {
            pauseFor(kReconnectDelays[std::min(attempt++, kReconnectDelays.size() - 1)]);
        }
    }
    const std::lock_guard lock(mutex);
    running = false;
    if (asked) {
        settle({ErrorCode::Cancelled, context(), {}});
    }
}

void ProgramStopper::Private::use(Descriptor descriptor) {
    const std::lock_guard lock(mutex);
    socket = descriptor;
    renew = false;
    sent = false;
    second = false;
    connectionError = {};
    if (asked) {
        send();
    }
    changed.notify_all();
}

bool ProgramStopper::Private::wantsSecond() {
    const std::lock_guard lock(mutex);
    return std::exchange(second, false) && asked;
}

// Processes the connection until it ends, closes it and returns the reason for its end.
Error ProgramStopper::Private::listen(Descriptor descriptor) {
    use(descriptor);
    auto reader = std::make_unique<PrimaryReader>();
    std::uint64_t packages = 0;
    constexpr milliseconds kPoll(10);
    Error ended{ErrorCode::ConnectionClosed, context(), {}};
    bool goesOn = true;
    // The previous connection. It stays open, because closing a socket with unread data resets the connection
    // and could discard a stop request that was just sent on it.
    Descriptor before = -1;
    while (goesOn && !thread.cancel.isCancelled()) {
        if (wantsSecond()) {
            if (const auto opened = connectTcp(options.host, options.port,
                                               Deadline::after(kSecondConnectTime, thread.cancel));
                opened) {
                if (before >= 0) {
                    native_socket::close(before);
                }
                before = std::exchange(descriptor, *opened);
                reader = std::make_unique<PrimaryReader>();
                packages = 0;
                use(descriptor);
            }
        }
        const Status status = reader->read(descriptor, kPoll, *options.clock);
        goesOn = status == Status::Ok || status == Status::WouldBlock;
        if (!reader->understands()) {
            ended = PrimaryReader::notUnderstood(context());
            goesOn = false;
        }
        {
            const std::lock_guard lock(mutex);
            hear(reader->parser(), packages);
            look();
            goesOn = goesOn && !renew;
        }
    }
    // If a lost connection recovers, the operating system would deliver a buffered request, which would stop
    // the program running at that time. A reset discards the buffered request. If the stop is still wanted,
    // the request is sent on the next connection.
    bool reset = false;
    {
        const std::lock_guard lock(mutex);
        socket = -1;
        reset = sent && (asked || std::exchange(discard, false)) && !thread.cancel.isCancelled();
    }
    for (const Descriptor each : {before, descriptor}) {
        if (each >= 0) {
            if (reset) {
                native_socket::discardOnClose(each);
            }
            native_socket::close(each);
        }
    }
    return ended;
}

bool ProgramStopper::Private::pauseFor(milliseconds time) {
    // Short, because the robot may become reachable at any time while a stop is requested.
    constexpr milliseconds kWhileAsked(50);
    std::unique_lock lock(mutex);
    const auto wanted = [this] { return thread.cancel.isCancelled() || renew; };
    const auto end = std::chrono::steady_clock::now() + time;
    while (!wanted() && std::chrono::steady_clock::now() < end) {
        if (asked) {
            changed.wait_for(lock, kWhileAsked, wanted);
            break;
        }
        changed.wait_until(lock, end, [&] { return wanted() || asked; });
    }
    renew = false;
    return !thread.cancel.isCancelled();
}

ProgramStopper::ProgramStopper(const ProgramStopperOptions& options) : d_(std::make_unique<Private>()) {
    d_->options = options;
}

ProgramStopper::~ProgramStopper() {
    end();
}

void ProgramStopper::start() {
    d_->thread.begin([this] { d_->running = true; }, [d = d_.get()] { d->run(); });
}

void ProgramStopper::end() {
    d_->thread.end();
}

void ProgramStopper::requestStop() {
    {
        const std::lock_guard lock(d_->mutex);
        d_->asked = true;
        d_->discard = false;
        d_->refusals = 0;
        d_->askedNs = d_->now();
        d_->outcome = {};
        d_->send();
        d_->second = d_->socket >= 0;
        if (!d_->running) {
            d_->settle({ErrorCode::NotConnected, d_->context(), {}});
        }
    }
    d_->changed.notify_all();
}

void ProgramStopper::withdraw() {
    const std::lock_guard lock(d_->mutex);
    if (d_->asked) {
        d_->settle({ErrorCode::Cancelled, d_->context(), {}});
    }
}

Result<void> ProgramStopper::waitUntilStopped(const Deadline& deadline) const {
    std::unique_lock lock(d_->mutex);
    while (d_->asked) {
        if (deadline.hasExpired()) {
            return Error{
                deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, d_->context(), {}};
        }
        d_->changed.wait_for(lock, std::max(deadline.nextPoll(), milliseconds(1)));
    }
    return d_->outcome.code == ErrorCode::None ? Result<void>() : Result<void>(d_->outcome);
}

bool ProgramStopper::isUnderWay() const {
    const std::lock_guard lock(d_->mutex);
    return d_->asked;
}

Error ProgramStopper::error() const {
    const std::lock_guard lock(d_->mutex);
    return d_->outcome;
}

void ProgramStopper::reconnect() {
    {
        const std::lock_guard lock(d_->mutex);
        d_->renew = true;
    }
    d_->changed.notify_all();
}

bool ProgramStopper::isConnected() const {
    const std::lock_guard lock(d_->mutex);
    return d_->socket >= 0;
}

}  // namespace tiller::script
