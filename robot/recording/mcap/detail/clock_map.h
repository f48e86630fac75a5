// SPDX-License-Identifier: MIT
#pragma once

// Puts the controller's clock on the calendar: its time stamps are even where arrivals on this computer are not. The
// package that came soonest tells the difference of the two clocks; where they drift apart, the map follows slowly.
// Private to MCAP.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace tiller::recording::mcap {

/// Threads  one
class ClockMap {
public:
    /// timestamp   of the controller [s]; NaN: the arrival is all there is
    /// arrivalNs   [ns since 1970]
    /// connection  another one may be another controller
    /// Returns     when it was sent [ns since 1970], never before the one before
    std::int64_t toUtc(double timestamp, std::int64_t arrivalNs, std::uint64_t connection) {
        // 25 ppm at 500 packages a second: more than two quartz clocks part by.
        constexpr std::int64_t kDriftNs = 50;
        constexpr std::int64_t kRestartedNs = 1'000'000'000;
        std::int64_t sent = arrivalNs;
        if (std::isfinite(timestamp) && std::abs(timestamp) < 1e9) {
            const auto robotNs = static_cast<std::int64_t>(std::llround(timestamp * 1e9));
            const std::int64_t difference = arrivalNs - robotNs;
            if (!difference_ || connection != connection_ || difference > *difference_ + kRestartedNs) {
                difference_ = difference;
            } else {
                difference_ = std::min(difference, *difference_ + kDriftNs);
            }
            connection_ = connection;
            sent = robotNs + *difference_;
        }
        last_ = std::max(sent, last_);
        return last_;
    }

private:
    std::optional<std::int64_t> difference_;
    std::uint64_t connection_ = 0;
    std::int64_t last_ = 0;
};

}  // namespace tiller::recording::mcap
