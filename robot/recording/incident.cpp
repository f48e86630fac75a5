// SPDX-License-Identifier: MIT
#include "robot/recording/incident.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace tiller::recording {

namespace {

template <class Number>
std::optional<Number> factNumber(const Recording& recording, const char* fact) {
    const auto found = recording.facts().find(fact);
    Number value{};
    if (found == recording.facts().end()) {
        return std::nullopt;
    }
    const char* const end = found->second.data() + found->second.size();
    const auto [stop, failed] = std::from_chars(found->second.data(), end, value);
    return failed == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

Result<double> timeOf(const Recording& recording, std::uint64_t row) {
    const auto times = recording.times({row, 1});
    if (!times) {
        return times.error();
    }
    return times->empty() ? 0.0 : times->front();
}

}  // namespace

Result<std::optional<double>> incidentMoment(const Recording& recording) {
    if (!recording.facts().contains(kIncidentFact) || recording.rows() == 0) {
        return std::optional<double>();
    }
    const auto timestamp = factNumber<double>(recording, kIncidentTimeFact);
    if (const auto column = recording.indexOf("timestamp"); timestamp && column) {
        const auto stamps = recording.read(std::array{*column}, {0, recording.rows()});
        if (!stamps) {
            return stamps.error();
        }
        // Use the last match, because the controller time starts at zero after a restart.
        const std::vector<double>& all = stamps->front();
        if (const auto found = std::find(all.rbegin(), all.rend(), *timestamp); found != all.rend()) {
            const auto row = static_cast<std::uint64_t>(std::distance(found, all.rend()) - 1);
            const Result<double> time = timeOf(recording, row);
            return time ? Result<std::optional<double>>(std::optional(*time)) : time.error();
        }
    }
    const auto utcNs = factNumber<std::int64_t>(recording, kIncidentUtcFact);
    const auto startNs = recording.startUtcNs();
    if (!utcNs || !startNs) {
        return std::optional<double>();
    }
    const Result<double> last = timeOf(recording, recording.rows() - 1);
    if (!last) {
        return last.error();
    }
    return std::optional(std::clamp(static_cast<double>(*utcNs - *startNs) / 1e9, 0.0, *last));
}

}  // namespace tiller::recording
