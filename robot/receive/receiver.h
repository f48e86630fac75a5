// SPDX-License-Identifier: MIT
#pragma once

// Follows a robot: one RTDE connection, one thread, every package published as "the newest" and into a ring
// that any number of subscribers read at their own pace. Comes back by itself when the connection breaks.

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
#include "robot/realtime/histogram.h"
#include "robot/realtime/ring.h"
#include "robot/realtime/thread_priority.h"
#include "robot/receive/sample.h"
#include "robot/rtde/protocol.h"

namespace tiller::receive {

/// What the interface shows and what recordings usually want: all of it known to every robot or absent
/// without harm.
std::vector<std::string> defaultFields();

/// What Receiver::waitForData() does where nothing listens.
enum class OnRefusal : std::uint8_t { Fail, Wait };

struct ReceiverOptions {
    Text host = {};
    std::uint16_t port = rtde::kPort;
    /// Packages a second; 0: as many as the controller gives (500, on CB3 125).
    double frequency = 0;
    /// "timestamp" is added if missing.
    std::vector<std::string> fields = defaultFields();
    /// SCHED_FIFO priority of the thread, where the system permits; 0 asks for none.
    int priority = 90;
    /// The thread stays on these CPUs, counted from 0; empty: where the system puts it.
    std::vector<int> cpus = {};
    /// Stamps samples and measures ages. Must outlive the receiver.
    const Clock* clock = &SteadyClock::shared();
    /// How long one attempt to connect and shake hands may take. Together with the longest of the delays it
    /// is below 2 s: so soon data flow again when the path to the robot is back, whatever was under way then.
    std::chrono::milliseconds connectTimeout{1300};
    /// Waits between attempts, on the clock; the last one repeats.
    std::vector<std::chrono::milliseconds> reconnectDelays{
        std::chrono::milliseconds(100), std::chrono::milliseconds(250), std::chrono::milliseconds(500)};
    /// Silence on the clock after which the connection is given up and made anew.
    std::chrono::milliseconds silenceLimit{2500};
    /// Samples kept for subscribers that are busy: 8 s at 500 Hz.
    std::size_t ringCapacity = 4096;
};

enum class ReceiverState {
    Stopped,     ///< start() not called, or stop() was
    Connecting,  ///< an attempt is under way
    Receiving,   ///< connected; see Counters and ageNs() for whether data come
    Waiting,     ///< an attempt failed or the connection broke; the next attempt is due
};

struct ReceiverCounters {
    std::uint64_t packets = 0;
    std::uint64_t late = 0;         ///< came more than half a period after their time
    std::uint64_t lost = 0;         ///< skipped by the controller, by its own time stamps
    std::uint64_t reconnects = 0;   ///< connections made after the first
    double rateHz = 0;              ///< over the last half second
    std::int64_t lastJitterNs = 0;  ///< how far the newest package was from its time
};

/// One consumer's place in the stream.
/// Threads  one at a time. Stays valid after the receiver is gone. Real-time: yes
class Subscription {
public:
    Subscription() = default;

    /// Fills `sample` with the next one. A Sample that is passed again and again is filled without
    /// allocating.
    /// Returns  false when there is none just now
    bool next(Sample& sample);
    /// The same, and waits for it. As long as somebody waits, each package costs the receive thread one
    /// system call to wake them.
    /// Errors   Timeout, Cancelled; NotConnected when the receiver was stopped, is gone, or never was. Where
    ///          there is no link, the reason is the message: "ConnectionRefused: connect to ..."
    /// Blocks   until the deadline. Real-time: no
    Result<void> next(Sample& sample, const Deadline& deadline);
    /// The same into a sample of its own.
    Result<Sample> next(const Deadline& deadline);
    /// Samples that were overwritten because nobody fetched them.
    std::uint64_t lost() const { return cursor_.lost; }
    std::uint64_t pending() const;                       ///< Samples not yet taken.
    bool isValid() const { return stream_ != nullptr; }  ///< Made by subscribe().

private:
    friend class Receiver;
    struct Stream;
    std::shared_ptr<const Stream> stream_;
    realtime::BroadcastRing::Cursor cursor_;
};

/// Owns the thread "tiller-receive" (SCHED_FIFO 90 where permitted), which opens, reads and closes the RTDE
/// connection. What crosses: samples outward through a seqlock and a ring; stop() inward through a flag.
/// Threads  any for everything; start() and stop() from one
class Receiver {
public:
    explicit Receiver(ReceiverOptions options);
    ~Receiver();
    Receiver(const Receiver&) = delete;
    Receiver& operator=(const Receiver&) = delete;

    /// Starts the thread; does not wait for a connection: waitForData() does.
    /// Errors   FieldUnknown, naming each name in `fields` that is not an RTDE output, and the one most like
    ///          it; InvalidArgument (no host)
    /// Blocks   never
    Result<void> start();
    /// Ends the thread, within 250 ms whatever the peer does.
    void stop();

    ReceiverState state() const;  ///< Of the connection. Any thread
    /// The port of this end of the connection; 0 when there is none. Any thread
    std::uint16_t localPort() const;
    /// Why start() refused, the last attempt failed or the last connection broke; code None when connected.
    Error lastError() const;
    ReceiverCounters counters() const;  ///< Since start(). Any thread
    /// Counters back to zero, reconnects too. Takes effect with the next package.
    void resetCounters();
    /// Distance between neighbouring packages on the host [ns], since the last reset.
    realtime::Histogram intervals() const;

    /// Of the controller connected to last; zeros before the first connection.
    SoftwareVersion version() const;
    /// Time between two packages [s]; 0 before the first connection.
    double period() const;
    /// Fields asked for that the robot does not have.
    std::vector<std::string> absentFields() const;
    /// What the system said to the wish for priority; its advice also tells why the CPUs were refused.
    realtime::PriorityReport priority() const;

    const std::shared_ptr<const SampleLayout>& layout() const;  ///< Of every sample.
    /// The newest sample; sequence 0 when there is none yet. Real-time: latest(Sample&) yes, latest() no
    Sample latest() const;
    void latest(Sample& into) const;  ///< The same without an allocation.
    /// The newest sample, as soon as there is one of the present connection that is not older than 100 ms:
    /// what a program begins with that is to compute a target from where the arm is.
    /// Errors   why the connection could not be made, when that is known (ConnectionRefused, HostUnreachable,
    ///          FieldUnknown ...); Timeout, Cancelled; NotConnected when start() was not called
    /// onRefusal  of a connection that is refused, or a host that cannot be resolved, before any data came: to fail at
    ///            once, or to wait like for a robot that is booting
    /// Blocks   until the deadline; attempts to connect go on by themselves meanwhile. A robot that sent data before is
    ///          always waited for
    Result<Sample> waitForData(const Deadline& deadline, OnRefusal onRefusal = OnRefusal::Fail) const;
    /// Age of the newest sample on the receiver's clock; the largest number there is when there is none. A
    /// sample read out of a backlog is as old as it lay there, by the robot's time stamps.
    std::int64_t ageNs() const;
    /// The newest sample is no older than this.
    bool isFresh(std::chrono::nanoseconds limit) const { return ageNs() <= limit.count(); }

    /// Everything received from now on.
    Subscription subscribe() const;

private:
    struct Worker;
    std::unique_ptr<Worker> d_;
};

}  // namespace tiller::receive
