// SPDX-License-Identifier: MIT
#pragma once

// What everybody who listens to the primary interface does alike: a thread that is begun and ended, waits between
// two attempts to connect, and bytes that become packages. What is done with the packages is the listener's own.

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

#include "robot/core/clock.h"
#include "robot/core/deadline.h"
#include "robot/core/error.h"
#include "robot/core/native_socket.h"
#include "robot/script/detail/primary_parser.h"

namespace tiller::script {

/// Between two attempts to connect; the last one repeats.
inline constexpr std::array<std::chrono::milliseconds, 4> kReconnectDelays{
    std::chrono::milliseconds(500), std::chrono::milliseconds(1000), std::chrono::milliseconds(2000),
    std::chrono::milliseconds(5000)};

/// A controller sends its state ten times a second. One that is silent for so long has forgotten the
/// connection, or cannot be reached; nothing else would show it.
inline constexpr std::chrono::milliseconds kPrimaryTimeout(2500);

/// What ends whatever program runs.
inline constexpr std::string_view kStopProgram = "stop program\n";

native_socket::Transfer sendStopProgram(native_socket::Descriptor descriptor);

/// The thread of its owner, who names it. Ends by the token and by `changed`, on which the owner waits.
/// Threads  one for begin() and end()
class ListenerThread {
public:
    /// mutex, changed  of the owner; must outlive this
    ListenerThread(std::mutex& mutex, std::condition_variable& changed) : mutex_(mutex), changed_(changed) {}

    /// Does nothing when it runs already.
    /// prepare  runs before, under the mutex
    template <class Prepare, class Run>
    void begin(Prepare prepare, Run run) {
        if (thread_.joinable()) {
            return;
        }
        {
            const std::lock_guard lock(mutex_);
            prepare();
        }
        cancel = CancelToken();
        thread_ = std::thread(std::move(run));
    }
    /// Cancels and joins.
    void end();

    CancelToken cancel;  ///< of this run of the thread

private:
    std::mutex& mutex_;
    std::condition_variable& changed_;
    std::thread thread_;
};

/// The packages of one connection.
/// Threads  one
class PrimaryReader {
public:
    /// Waits at most so long for bytes, and takes what has come. clock  stamps the messages
    /// Returns  Ok when something was taken, WouldBlock when nothing came, Failed also after kPrimaryTimeout
    ///          without a byte, or why nothing more can come
    native_socket::Status read(native_socket::Descriptor descriptor, std::chrono::milliseconds atMost,
                               const Clock& clock);
    PrimaryParser& parser() { return parser_; }
    std::size_t lastBytes() const { return lastBytes_; }  ///< taken by the last read()
    /// False once a package had a length that makes no sense: the connection is to be given up.
    bool understands() const { return understands_; }
    /// What it is given up with.
    static Error notUnderstood(const QString& context);

private:
    PrimaryParser parser_;
    std::array<std::uint8_t, 8192> bytes_;
    std::size_t lastBytes_ = 0;
    bool understands_ = true;
    std::optional<std::int64_t> heardNs_;  ///< when bytes came last; at first, when they were waited for
};

}  // namespace tiller::script
