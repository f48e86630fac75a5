// SPDX-License-Identifier: MIT
#pragma once

// Converts controller time to UTC. Controller time stamps are regular, whereas arrival times have jitter. The
// packet with the smallest delay determines the offset between the two clocks, and the conversion slowly
// follows their drift. Private to robot/recording/mcap.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace tiller::recording::mcap {

/// Threads  one
class ClockMap {
public:
    /// timestamp   of the controller [s]; NaN: the arrival time is used
    /// arrivalNs   [ns since 1970]
    /// connection  number of the connection; a change may mean a different controller
    /// Returns     the send time [ns since 1970], never earlier than the previous result
    std::int64_t toUtc(double timestamp, std::int64_t arrivalNs, std::uint64_t connection) {
        // 25 ppm at 500 packets per second, which exceeds the drift between two quartz clocks.
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
