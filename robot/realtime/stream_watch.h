// SPDX-License-Identifier: MIT
#pragma once

// Monitors a stream of packets with two clocks. The controller's time stamps reveal missing packets; the
// host's clock reveals late ones.

#include <cstdint>

namespace tiller::realtime {

/// Threads  one. Real-time: yes
class StreamWatch {
public:
    struct Verdict {
        std::uint64_t lost = 0;  ///< number of packets missing before this one
        bool late = false;       ///< more than half a period late
        /// Delay relative to the expected arrival [ns]; 0 for the earliest packet. For packets of a backlog,
        /// the delay is their age.
        std::int64_t jitterNs = 0;
    };

    /// Starts a new connection. The first packet is compared only with the last time stamp of the previous
    /// connection, to determine the number of packets lost during the interruption.
    /// period  time between packets [s]
    void begin(double period);
    /// timestamp  time stamp of the controller [s]; NaN if the controller does not send one
    Verdict add(double timestamp, std::int64_t hostNs);

private:
    double period_ = 0.002;
    double lastTimestamp_ = 0;
    bool hasTimestamp_ = false;
    bool hasBase_ = false;
    double baseNs_ = 0;  ///< host time minus robot time of the earliest packets
    // `settledNs_` is like `baseNs_`, but only for the packets since `settlingSinceNs_`: since the last pause
    // of the stream, but for at most 1 s.
    std::int64_t settlingSinceNs_ = 0;
    std::int64_t lastHostNs_ = 0;
    double settledNs_ = 0;
};

}  // namespace tiller::realtime
