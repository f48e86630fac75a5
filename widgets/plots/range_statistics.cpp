// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/range_statistics.h"

#include <algorithm>
#include <cmath>

#include "widgets/signals/signal_store.h"

namespace tiller {

std::optional<RangeStatistics> rangeStatistics(const SignalStore& store, int signal, double from, double to) {
    const SeriesBuffer* history = store.buffer(signal);
    if (history == nullptr || history->isEmpty()) {
        return std::nullopt;
    }
    const double begin = std::min(from, to);
    const double end = std::max(from, to);
    RangeStatistics all;
    // Means and moments are carried along, so that a small ripple on a large value is not lost in rounding.
    double meanTime = 0;
    double squares = 0;      // about the mean
    double timeSquares = 0;  // about the mean
    double products = 0;     // about both means
    double rawSquares = 0;
    MinMax extent;
    for (std::int64_t i = history->lowerBound(begin); i < history->end() && history->time(i) <= end; ++i) {
        const double value = store.value(signal, i);
        if (std::isnan(value)) {
            continue;
        }
        ++all.count;
        extent.add(value);
        const auto count = static_cast<double>(all.count);
        const double time = history->time(i) - begin;
        const double timeStep = time - meanTime;
        const double step = value - all.mean;
        meanTime += timeStep / count;
        all.mean += step / count;
        squares += step * (value - all.mean);
        timeSquares += timeStep * (time - meanTime);
        products += timeStep * (value - all.mean);
        rawSquares += value * value;
    }
    if (all.count == 0) {
        return std::nullopt;
    }
    all.min = extent.min;
    all.max = extent.max;
    all.rms = std::sqrt(rawSquares / static_cast<double>(all.count));
    all.deviation = std::sqrt(squares / static_cast<double>(all.count));
    all.slope = timeSquares > 0 ? products / timeSquares : 0;
    return all;
}

}  // namespace tiller
