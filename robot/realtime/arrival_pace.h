// SPDX-License-Identifier: MIT
#pragma once

// When to work on packages that a sender makes at even times and that arrive unevenly: at even times again,
// as little after their arrival as that allows. The sender's time stamps give the pace, the arrivals the
// phase.

#include <cstdint>

namespace tiller::realtime {

/// Threads  one. Real-time: yes
class ArrivalPace {
public:
    /// period  between two packages [s]; none is held back for more than half of it, nor for more than 1 ms
    explicit ArrivalPace(double period);

    /// A package made at `senderTime` [s] arrived. Time stamps that go back or leap begin anew.
    /// awaited  false: it may have come before `arrivedNs`, nobody looked
    /// Returns  when to work on it [ns]: evenly after the others, or at once when it came too late for that
    std::int64_t follow(std::int64_t arrivedNs, double senderTime, bool awaited = true);

    /// When the one made then is to be worked on, wherever it is [ns]. Not before the first follow().
    std::int64_t expectedNs(double senderTime) const;
    /// Whether enough have come to expect the next ones.
    bool isSettled() const { return packages_ >= 300; }

private:
    void begin(double delay);
    void learn(double late);
    void learnMargin(double more);
    void holdLess(double late);
    void hold();

    double periodNs_;
    double mostNs_;          ///< highest margin
    double senderTime_ = 0;  ///< of the newest package [s]
    double packages_ = 0;
    double origin_ = 0;       ///< arrival minus sender's time of the first package [ns]
    double usualNs_ = 0;      ///< median of the same, of the others, since `origin_`
    double marginNs_ = 0;     ///< how much later than usual all but one in a thousand come
    double latestNs_ = 0;     ///< how much later than usual the latest of the first came
    double heldNs_ = 0;       ///< when they are worked on, since `origin_`: follows usual and margin
    int lateInARow_ = 0;      ///< packages later than any margin
    double leastLateNs_ = 0;  ///< the least that one of these was later than usual
};

}  // namespace tiller::realtime
