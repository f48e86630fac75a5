// SPDX-License-Identifier: MIT
#pragma once

// Receives the data of a robot with one RTDE connection and one thread. Publishes every packet as the latest
// sample and in a ring buffer for any number of subscribers. Reconnects automatically.

#include <QString>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/clock.h"
#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "robot/core/text.h"
#include "robot/core/version.h"
#include "robot/platform/thread_priority.h"
#include "robot/realtime/histogram.h"
#include "robot/realtime/ring.h"
#include "robot/receive/sample.h"
#include "robot/rtde/protocol.h"

namespace tiller::receive {

/// The fields of the user interface and of typical recordings. Fields that a robot does not have are reported as
/// absent.
std::vector<std::string> defaultFields();

/// Behaviour of Receiver::waitForData() if the connection is refused.
enum class OnRefusal : std::uint8_t { Fail, Wait };

struct ReceiverOptions {
    Text host = {};
    std::uint16_t port = rtde::kPort;
    /// Packets per second; 0: the maximum of the controller (500, or 125 on CB3).
    double frequency = 0;
    /// "timestamp" is added if missing.
    std::vector<std::string> fields = defaultFields();
    /// SCHED_FIFO priority of the thread, if permitted by the system; 0 requests no priority.
    int priority = 90;
    /// CPUs of the thread, counted from 0; empty: chosen by the system.
    std::vector<int> cpus = {};
    /// Clock for time stamps and ages. It must outlive the receiver.
    const Clock* clock = &SteadyClock::shared();
    /// Limit for one attempt to connect and complete the handshake. This limit plus the longest delay is
    /// below 2 s, so data resume within 2 s after the network has recovered.
    std::chrono::milliseconds connectTimeout{1300};
    /// Delays between attempts, measured on the receiver's clock. The last delay repeats.
    std::vector<std::chrono::milliseconds> reconnectDelays{
        std::chrono::milliseconds(100), std::chrono::milliseconds(250), std::chrono::milliseconds(500)};
    /// After this time without data, the connection is closed and reopened.
    std::chrono::milliseconds silenceLimit{2500};
    /// Samples buffered for busy subscribers: 8 s at 500 Hz.
    std::size_t ringCapacity = 4096;
};

enum class ReceiverState {
    Stopped,     ///< not started, or stopped
    Connecting,  ///< an attempt is in progress
    Receiving,   ///< connected; ReceiverCounters and ageNs() describe the data
    Waiting,     ///< an attempt or the connection failed; waiting for the next attempt
};

struct ReceiverCounters {
    std::uint64_t packets = 0;
    std::uint64_t late = 0;         ///< arrived more than half a period late
    std::uint64_t lost = 0;         ///< skipped by the controller, according to its time stamps
    std::uint64_t reconnects = 0;   ///< connections after the first connection
    double rateHz = 0;              ///< average over the last half second
    std::int64_t lastJitterNs = 0;  ///< deviation of the newest packet from its expected arrival time
};

/// The read position of one consumer in the stream. Valid even after the receiver is destroyed.
/// Threads  one at a time. Real-time: yes
class Subscription {
public:
    Subscription() = default;

    /// Reads the next sample. Reusing the same Sample avoids allocation.
    /// Returns  false if there is no new sample
    bool next(Sample& sample);
    /// Waits for the next sample. While a subscriber waits, each packet costs the receive thread one system
    /// call to wake it.
    /// Errors   Timeout, Cancelled; NotConnected if the receiver is stopped or destroyed. Without a
    ///          connection, the message contains the reason: "ConnectionRefused: connect to ..."
    /// Blocks   until the deadline. Real-time: no
    Result<void> next(Sample& sample, const Deadline& deadline);
    /// Waits for the next sample and returns it in a new object.
    Result<Sample> next(const Deadline& deadline);
    /// Samples that were overwritten before they were read.
    std::uint64_t lost() const { return cursor_.lost; }
    std::uint64_t pending() const;                       ///< Samples not yet read.
    bool isValid() const { return stream_ != nullptr; }  ///< True if created by subscribe().

private:
    friend class Receiver;
    struct Stream;
    std::shared_ptr<const Stream> stream_;
    realtime::BroadcastRing::Cursor cursor_;
};

/// Owns the thread "tiller-receive" (SCHED_FIFO 90 if permitted), which opens, reads and closes the RTDE
/// connection. The thread publishes samples through a seqlock and a ring buffer.
/// Threads  any for all functions; start() and stop() from one thread
class Receiver {
public:
    explicit Receiver(ReceiverOptions options);
    ~Receiver();
    Receiver(const Receiver&) = delete;
    Receiver& operator=(const Receiver&) = delete;

    /// Starts the thread without waiting for a connection; see waitForData().
    /// Errors   FieldUnknown, with each name in `fields` that is not an RTDE output and the most similar
    ///          output name; InvalidArgument (no host)
    /// Blocks   never
    Result<void> start();
    /// Ends the thread within 250 ms, even if the peer does not respond.
    void stop();

    ReceiverState state() const;  ///< Threads: any
    /// Local port of the connection; 0 if not connected. Threads: any
    std::uint16_t localPort() const;
    /// Reason why start() or the last attempt failed, or why the last connection was lost. Code None while
    /// connected.
    Error lastError() const;
    ReceiverCounters counters() const;  ///< Counters since start(). Threads: any
    /// Resets all counters, including reconnects, at the next packet.
    void resetCounters();
    /// Intervals between consecutive packets on the host [ns], since the last reset.
    realtime::Histogram intervals() const;

    /// Software version of the last connected controller; zeros before the first connection.
    SoftwareVersion version() const;
    /// Time between two packets [s]; 0 before the first connection.
    double period() const;
    /// Requested fields that the robot does not have.
    std::vector<std::string> absentFields() const;
    /// Result of the priority request. Its advice also covers refused CPU settings.
    realtime::PriorityReport priority() const;

    const std::shared_ptr<const SampleLayout>& layout() const;
    /// The newest sample; sequence 0 without data. Real-time: latest(Sample&) yes, latest() no
    Sample latest() const;
    void latest(Sample& into) const;  ///< Like latest(), without an allocation.
    /// Waits for a sample of the current connection that is not older than 100 ms, and returns it. Use
    /// this function in programs that compute their first target from the arm position.
    /// onRefusal  reaction if the connection is refused or the host name cannot be resolved before any data
    ///            have arrived: fail at once, or wait as for a robot that is booting
    /// Errors     the reason why the connection failed, if known (ConnectionRefused, HostUnreachable,
    ///            FieldUnknown, ...); Timeout, Cancelled; NotConnected if start() was not called
    /// Blocks     until the deadline. The receiver continues to connect during the wait. If the robot has
    ///            sent data before, the call always waits
    Result<Sample> waitForData(const Deadline& deadline, OnRefusal onRefusal = OnRefusal::Fail) const;
    /// Age of the newest sample on the receiver's clock; the maximum value without a sample. Includes the
    /// time that the sample has waited in a backlog, according to the robot's time stamps.
    std::int64_t ageNs() const;
    /// True if the newest sample is not older than `limit`.
    bool isFresh(std::chrono::nanoseconds limit) const { return ageNs() <= limit.count(); }

    /// Creates a subscription to all samples received from now on.
    Subscription subscribe() const;

private:
    struct Worker;
    std::unique_ptr<Worker> d_;
};

}  // namespace tiller::receive
