// SPDX-License-Identifier: MIT
#include "robot/station/history/selected_signals.h"

#include <algorithm>
#include <utility>

#include "robot/recording/export.h"

namespace tiller {

SelectedSignals::SelectedSignals(const recording::Recording& file, const std::vector<Column>& columns)
    : file_(file), events_(file.events()) {
    const auto time = recording::timeColumn(file);
    columns_.push_back(time ? file.columns()[*time] : recording::RecordedColumn{"seconds", "s"});
    signals_.push_back(time ? RecordedSignal{{*time}} : RecordedSignal{});
    for (const Column& each : columns) {
        columns_.push_back(each.column);
        signals_.push_back(each.signal);
    }
}

void SelectedSignals::add(recording::RecordedEvent event) {
    const auto next = std::upper_bound(
        events_.begin(), events_.end(), event.seconds,
        [](double seconds, const recording::RecordedEvent& one) { return seconds < one.seconds; });
    events_.insert(next, std::move(event));
}

Result<std::vector<std::vector<double>>> SelectedSignals::read(std::span<const std::size_t> columns,
                                                               recording::RowRange rows) const {
    std::vector<RecordedSignal> wanted;
    for (const std::size_t column : columns) {
        if (const RecordedSignal& signal = signals_.at(column); !signal.columns.empty()) {
            wanted.push_back(signal);
        }
    }
    auto read = RecordedRows(file_, 0, std::move(wanted)).read(rows);
    if (!read) {
        return read.error();
    }
    std::vector<std::vector<double>> values;
    auto next = read->values.begin();
    for (const std::size_t column : columns) {
        if (!signals_[column].columns.empty()) {
            values.push_back(std::move(*next++));
            continue;
        }
        auto seconds = file_.times(rows);
        if (!seconds) {
            return seconds.error();
        }
        values.push_back(std::move(*seconds));
    }
    return values;
}

}  // namespace tiller
