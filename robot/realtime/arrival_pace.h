// SPDX-License-Identifier: MIT
#pragma once

// Schedules the processing of packets that are sent at regular intervals and arrive with jitter. The
// processing times are regular, with as little delay as possible. The sender's time stamps define the period,
// and the arrival times define the phase.

#include <cstdint>

namespace tiller::realtime {

/// Threads  one. Real-time: yes
class ArrivalPace {
public:
    /// period  time between two packets [s]; packets are delayed by at most half a period, and at most 1 ms
    explicit ArrivalPace(double period);

    /// Adds a packet with the time stamp `senderTime` [s]. Time stamps that go backwards or jump reset the
    /// estimate.
    /// awaited  false: the packet may have arrived before `arrivedNs`, because no thread was waiting for it
    /// Returns  the time at which to process the packet [ns]: at the regular interval, or immediately if it
    ///          arrived too late
    std::int64_t follow(std::int64_t arrivedNs, double senderTime, bool awaited = true);

    /// Expected processing time of the packet with this time stamp [ns]. Requires a previous call to
    /// follow().
    std::int64_t expectedNs(double senderTime) const;
    /// True after enough packets for a reliable prediction.
    bool isSettled() const { return packages_ >= 300; }

private:
    void begin(double delay);
    void learn(double late);
    void learnMargin(double more);
    void holdLess(double late);
    void hold();

    double periodNs_;
    double mostNs_;          ///< maximum of marginNs_
    double senderTime_ = 0;  ///< time stamp of the newest packet [s]
    double packages_ = 0;
    double origin_ = 0;       ///< arrival time minus time stamp of the first packet [ns]
    double usualNs_ = 0;      ///< median of this difference over all packets, relative to `origin_`
    double marginNs_ = 0;     ///< delay beyond the median that only one packet in a thousand exceeds
    double latestNs_ = 0;     ///< largest delay beyond the median among the first packets
    double heldNs_ = 0;       ///< processing time relative to `origin_`; follows median plus margin
    int lateInARow_ = 0;      ///< consecutive packets later than the maximum margin
    double leastLateNs_ = 0;  ///< smallest delay among these packets
};

}  // namespace tiller::realtime
