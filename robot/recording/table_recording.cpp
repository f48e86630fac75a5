// SPDX-License-Identifier: MIT
#include "robot/recording/table_recording.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "robot/recording/detail/column_knowledge.h"
#include "robot/recording/detail/ranges.h"
#include "robot/recording/detail/restart_note.h"
#include "robot/recording/recorder.h"

namespace tiller::recording {

namespace {

constexpr double kUsualPeriod = 0.002;  // [s]
// An unsorted table has a step back in about every second row.
constexpr std::size_t kMaxRestarts = 100;
// Number of rows for determining the usual interval.
constexpr std::size_t kRowsForPeriod = 1000;

/// Median of the intervals; 0 without intervals.
double medianStep(std::span<const double> times) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < times.size() && steps.size() < kRowsForPeriod; ++i) {
        if (times[i] > times[i - 1]) {
            steps.push_back(times[i] - times[i - 1]);
        }
    }
    if (steps.empty()) {
        return 0;
    }
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

}  // namespace

TableRecording::TableRecording(RecordedTable table) : table_(std::move(table)) {
    findTimes();
    findGaps();
    addNotes();
}

void TableRecording::findTimes() {
    const std::size_t rowCount = table_.values.empty() ? 0 : table_.values.front().size();
    const std::optional<std::size_t> axis = timeColumnOf(table_.columns);
    times_.resize(rowCount);
    if (!axis) {
        for (std::size_t i = 0; i < rowCount; ++i) {
            times_[i] = static_cast<double>(i) * kUsualPeriod;
        }
        period_ = rowCount > 1 ? kUsualPeriod : 0;
        return;
    }
    const std::vector<double>& stamps = table_.values[*axis];
    period_ = medianStep(stamps);
    // Only the time stamps of a robot restart at zero with its controller.
    const bool isRobotTime = table_.columns[*axis].name == "timestamp";
    double shift = 0;
    double previous = 0;
    double last = 0;  // time stamp of the robot
    bool first = true;
    for (std::size_t i = 0; i < rowCount; ++i) {
        double time = previous;
        if (std::isfinite(stamps[i])) {
            if (first) {
                shift = -stamps[i];
                first = false;
            } else if (stamps[i] + shift < previous) {
                shift = previous + period_ - stamps[i];
                if (isRobotTime && events_.size() < kMaxRestarts) {
                    events_.push_back({previous + period_, kRestartLevel, QLatin1String(kRestartSource),
                                       restartText(last, stamps[i])});
                }
            }
            time = stamps[i] + shift;
            last = stamps[i];
        }
        times_[i] = time;
        previous = time;
    }
}

void TableRecording::addNotes() {
    for (const auto& [row, note] : table_.notes) {
        events_.push_back(note);
        events_.back().seconds =
            times_.empty() ? 0 : times_[std::min(static_cast<std::size_t>(row), times_.size() - 1)];
    }
    std::stable_sort(events_.begin(), events_.end(),
                     [](const RecordedEvent& a, const RecordedEvent& b) { return a.seconds < b.seconds; });
}

void TableRecording::findGaps() {
    const auto lost = indexOf(kLostColumn);
    for (std::size_t i = 1; i < times_.size(); ++i) {
        const double step = times_[i] - times_[i - 1];
        if (lost) {
            if (const double packets = table_.values[*lost][i]; packets >= 1 && packets < 1e15) {
                gaps_.push_back({i, static_cast<std::uint64_t>(packets), step});
            }
        } else if (period_ > 0 && step > 1.5 * period_) {
            gaps_.push_back(
                {i, static_cast<std::uint64_t>(std::llround(std::min(step / period_, 1e15))) - 1, step});
        }
    }
}

Result<std::vector<double>> TableRecording::times(RowRange range) const {
    const RowRange part = within(range, rows());
    return std::vector<double>(times_.begin() + static_cast<std::ptrdiff_t>(part.first),
                               times_.begin() + static_cast<std::ptrdiff_t>(part.first + part.count));
}

Result<std::vector<std::vector<double>>> TableRecording::read(std::span<const std::size_t> wanted,
                                                              RowRange range) const {
    const RowRange part = within(range, rows());
    std::vector<std::vector<double>> out;
    for (const std::size_t column : wanted) {
        const std::vector<double>& values = table_.values.at(column);
        out.emplace_back(values.begin() + static_cast<std::ptrdiff_t>(part.first),
                         values.begin() + static_cast<std::ptrdiff_t>(part.first + part.count));
    }
    return out;
}

}  // namespace tiller::recording
