// SPDX-License-Identifier: MIT
#pragma once

// Judges a stream of packages by two clocks: the controller's time stamps tell what is missing, the host's
// clock tells what came late.

#include <cstdint>

namespace tiller::realtime {

/// Threads  one. Real-time: yes
class StreamWatch {
public:
    struct Verdict {
        std::uint64_t lost = 0;  ///< packages missing just before this one
        bool late = false;       ///< more than half a period after its time
        /// Delay behind the expected arrival [ns]; 0 for the earliest packet. One out of a backlog is as old
        /// as this.
        std::int64_t jitterNs = 0;
    };

    /// A new connection: its first package is compared with nothing but the last time stamp, which tells how
    /// many packages the interruption cost.
    /// period  between packages [s]
    void begin(double period);
    /// timestamp  of the controller [s]; NaN when it does not send one
    Verdict add(double timestamp, std::int64_t hostNs);

private:
    double period_ = 0.002;
    double lastTimestamp_ = 0;
    bool hasTimestamp_ = false;
    bool hasBase_ = false;
    double baseNs_ = 0;  ///< host time minus robot time of the packages that came soonest
    // The same since `settlingSinceNs_`, from when on packages came without a pause.
    std::int64_t settlingSinceNs_ = 0;
    std::int64_t lastHostNs_ = 0;
    double settledNs_ = 0;
};

}  // namespace tiller::realtime
