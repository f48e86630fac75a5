// SPDX-License-Identifier: MIT
#include "robot/recording/table_recording.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "robot/recording/detail/column_knowledge.h"
#include "robot/recording/detail/ranges.h"
#include "robot/recording/detail/time_axis.h"
#include "robot/recording/recorder.h"

namespace tiller::recording {

TableRecording::TableRecording(RecordedTable table) : table_(std::move(table)) {
    findTimes();
    addNotes();
}

void TableRecording::findTimes() {
    if (!table_.axis) {
        table_.axis.emplace();
        table_.axis->column = timeColumnOf(table_.columns);
        table_.axis->isController =
            table_.axis->column && table_.columns[*table_.axis->column].name == "timestamp";
    }
    const TimeAxis& axis = *table_.axis;
    const auto valuesOf = [this](const std::optional<std::size_t>& column) {
        return column ? std::span<const double>(table_.values[*column]) : std::span<const double>();
    };
    TimeLine line = timeLine(axis, valuesOf(axis.column), valuesOf(axis.nanoseconds),
                             table_.values.empty() ? 0 : table_.values.front().size());
    times_ = std::move(line.seconds);
    period_ = line.period;
    events_ = std::move(line.restarts);
    findGaps(line.breaks);
}

void TableRecording::addNotes() {
    for (const auto& [row, note] : table_.notes) {
        events_.push_back(note);
        events_.back().seconds =
            rows() == 0 ? 0 : times_[std::min(static_cast<std::size_t>(row), times_.size() - 1)];
    }
    std::stable_sort(events_.begin(), events_.end(),
                     [](const RecordedEvent& a, const RecordedEvent& b) { return a.seconds < b.seconds; });
}

void TableRecording::findGaps(const std::vector<RecordedGap>& breaks) {
    const auto lost = indexOf(kLostColumn);
    auto segment = breaks.begin();
    for (std::size_t i = 1; i < times_.size(); ++i) {
        const double step = times_[i] - times_[i - 1];
        if (segment != breaks.end() && segment->row == i) {
            gaps_.push_back(*segment++);
        } else if (lost) {
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
