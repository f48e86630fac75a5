// SPDX-License-Identifier: MIT
#include "robot/station/history/recorded_clock.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tiller {

namespace {

/// Maximum difference between the time of a restart event, which is a time of arrival, and the time of the
/// first row after the restart.
constexpr double kMaxEventDelay = 2;  // [s]
constexpr std::size_t kMaxRestarts = 100;

}  // namespace

RecordedClock::RecordedClock(const recording::Recording& file, double begin)
    : begin_(begin), startUtcNs_(file.startUtcNs()) {
    const auto column = file.indexOf("timestamp");
    if (!column) {
        return;
    }
    const std::array<std::size_t, 1> wanted{*column};
    const auto add = [&](std::uint64_t row, double stamp) {
        const auto time = file.times({row, 1});
        if (time && !time->empty() && std::isfinite(stamp)) {
            clocks_.emplace_back(begin + time->front(), begin + time->front() - stamp);
        }
    };
    if (const auto first = file.read(wanted, {0, 1}); first && !first->front().empty()) {
        add(0, first->front().front());
    }
    for (const recording::RecordedEvent& event : file.events()) {
        const auto from = file.rowAt(event.seconds - kMaxEventDelay);
        const auto to = file.rowAt(event.seconds + kMaxEventDelay);
        if (event.source != QLatin1String("recorder") || !from || !to || clocks_.size() > kMaxRestarts) {
            continue;
        }
        const auto stamps = file.read(wanted, {*from, *to - *from + 1});
        for (std::size_t i = 1; stamps && i < stamps->front().size(); ++i) {
            if (stamps->front()[i] < stamps->front()[i - 1]) {
                add(*from + i, stamps->front()[i]);
            }
        }
    }
    std::sort(clocks_.begin(), clocks_.end());
}

std::optional<double> RecordedClock::controllerTime(double time) const {
    if (clocks_.empty()) {
        return std::nullopt;
    }
    const auto next = std::upper_bound(clocks_.begin(), clocks_.end(), time,
                                       [](double wanted, const auto& clock) { return wanted < clock.first; });
    const auto& clock = next == clocks_.begin() ? *next : *(next - 1);
    // Remove the rounding error of the difference. Time stamps have at most nine decimal places.
    constexpr double kPerSecond = 1e9;
    return std::round((time - clock.second) * kPerSecond) / kPerSecond;
}

std::optional<std::int64_t> RecordedClock::utcNs(double time) const {
    constexpr double kPerSecond = 1e9;
    return startUtcNs_ ? std::optional(*startUtcNs_ + std::llround((time - begin_) * kPerSecond))
                       : std::nullopt;
}

}  // namespace tiller
