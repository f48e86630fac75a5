// SPDX-License-Identifier: MIT
#pragma once

// Code shared by the clients of the primary interface: a thread that can be started, stopped and paused
// between connection attempts, and a reader that splits the stream into packages. The clients process the
// packages.

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
#include "robot/platform/native_socket.h"
#include "robot/script/detail/primary_parser.h"

namespace tiller::script {

/// Delays between connection attempts; the last delay repeats.
inline constexpr std::array<std::chrono::milliseconds, 4> kReconnectDelays{
    std::chrono::milliseconds(500), std::chrono::milliseconds(1000), std::chrono::milliseconds(2000),
    std::chrono::milliseconds(5000)};

/// A controller sends its state ten times per second. After this time without data, the connection is closed.
/// TCP does not report that the controller has dropped the connection or has become unreachable.
inline constexpr std::chrono::milliseconds kPrimaryTimeout(2500);

/// Ends any running program.
inline constexpr std::string_view kStopProgram = "stop program\n";

native_socket::Transfer sendStopProgram(native_socket::Descriptor descriptor);

/// The thread of a client. end() cancels the token and notifies `changed`, on which the thread waits.
/// Threads  begin() and end(): one at a time
class ListenerThread {
public:
    /// mutex, changed  members of the client that must outlive this object
    ListenerThread(std::mutex& mutex, std::condition_variable& changed) : mutex_(mutex), changed_(changed) {}

    /// Starts the thread. No effect if it is already running.
    /// prepare  called before the start, under the mutex
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
    /// Cancels and joins the thread.
    void end();

    CancelToken cancel;  ///< token of the current run of the thread

private:
    std::mutex& mutex_;
    std::condition_variable& changed_;
    std::thread thread_;
};

/// Reads the packages of one connection.
/// Threads  one
class PrimaryReader {
public:
    /// Waits for bytes, at most for the given time, and reads them.
    /// clock    for the time stamps of messages
    /// Returns  Ok after reading, WouldBlock without data, Failed after kPrimaryTimeout without data or when
    /// the connection has ended
    native_socket::Status read(native_socket::Descriptor descriptor, std::chrono::milliseconds atMost,
                               const Clock& clock);
    PrimaryParser& parser() { return parser_; }
    std::size_t lastBytes() const { return lastBytes_; }  ///< number of bytes of the last read()
    /// False after a package with an invalid length; the connection must then be closed.
    bool understands() const { return understands_; }
    /// The error for an invalid package length.
    static Error notUnderstood(const QString& context);

private:
    PrimaryParser parser_;
    std::array<std::uint8_t, 8192> bytes_;
    std::size_t lastBytes_ = 0;
    bool understands_ = true;
    std::optional<std::int64_t> heardNs_;  ///< time of the last received bytes, or start of the first wait
};

}  // namespace tiller::script
