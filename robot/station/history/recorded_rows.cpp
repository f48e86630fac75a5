// SPDX-License-Identifier: MIT
#include "robot/station/history/recorded_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/recording/formats/open_recording.h"

namespace tiller {

namespace {

constexpr double kNotThere = std::numeric_limits<double>::quiet_NaN();
/// Rows read per step: one block of the history, which is the amount of data that a recording keeps
/// decompressed.
constexpr std::uint64_t kRowsAtATime = static_cast<std::uint64_t>(SeriesColumn::kBlockRows);
/// Signals with a look-back use larger steps, because each step must read the preceding rows again.
constexpr std::uint64_t kRowsWithLookBack = 8 * kRowsAtATime;

}  // namespace

std::vector<double> axisOf(std::vector<double> seconds, double begin, std::uint64_t rows) {
    seconds.resize(static_cast<std::size_t>(rows), seconds.empty() ? 0 : seconds.back());
    double before = -std::numeric_limits<double>::infinity();
    for (double& time : seconds) {
        time += begin;
        if (!(time > before)) {
            time = std::nextafter(before, std::numeric_limits<double>::infinity());
        }
        before = time;
    }
    return seconds;
}

RecordedRows::RecordedRows(const recording::Recording& file, double begin, std::vector<RecordedSignal> wanted)
    : file_(file), begin_(begin), signals_(std::move(wanted)) {
    for (const RecordedSignal& signal : signals_) {
        std::vector<std::size_t>& places = places_.emplace_back();
        for (const std::size_t column : signal.columns) {
            const auto known = std::find(columns_.begin(), columns_.end(), column);
            places.push_back(static_cast<std::size_t>(known - columns_.begin()));
            if (known == columns_.end()) {
                columns_.push_back(column);
            }
        }
        std::shared_ptr<DerivedSignal>& derivation = derivations_.emplace_back();
        if (!signal.derivation.isEmpty()) {
            // The caller has already resolved the inputs.
            derivation = DerivedSignal::make(signal.derivation, [](const QString&) { return true; }).value();
            lookBack_ = std::max(lookBack_, derivation->lookBack());
        }
    }
}

Result<RecordedRows::Rows> RecordedRows::read(recording::RowRange range) {
    recording::RowRange whole = range;
    if (lookBack_ >= 0 && file_.period() > 0) {
        const auto before = std::min(range.first, static_cast<std::uint64_t>(lookBack_ / file_.period()) + 1 +
                                                      DerivedSignal::kMaxNesting + 1);
        whole = {range.first - before, range.count + before};
    }
    auto times = file_.times(whole);
    if (!times) {
        return times.error();
    }
    auto read = file_.read(columns_, whole);
    if (!read) {
        return read.error();
    }
    Rows inputs{axisOf(std::move(times).value(), begin_, whole.count), std::move(read).value()};
    for (std::vector<double>& column : inputs.values) {
        column.resize(static_cast<std::size_t>(whole.count), kNotThere);
    }
    const auto skipped = static_cast<std::ptrdiff_t>(range.first - whole.first);
    Rows rows;
    rows.times.assign(inputs.times.begin() + skipped, inputs.times.end());
    for (std::size_t i = 0; i < signals_.size(); ++i) {
        std::vector<double> values =
            derivations_[i] ? computed(i, inputs, whole.first) : inputs.values[places_[i].front()];
        values.erase(values.begin(), values.begin() + skipped);
        if (const int bit = signals_[i].bit; bit >= 0) {
            std::transform(values.begin(), values.end(), values.begin(), [bit](double value) {
                return value >= 0 ? static_cast<double>(static_cast<std::uint64_t>(value) >> bit & 1)
                                  : kNotThere;
            });
        }
        rows.values.push_back(std::move(values));
    }
    return rows;
}

std::vector<double> RecordedRows::computed(std::size_t signal, const Rows& inputs,
                                           std::uint64_t first) const {
    const std::vector<std::size_t>& places = places_[signal];
    SeriesBuffer history(0, HistoryLimits{1e12, std::numeric_limits<std::size_t>::max()});
    std::vector<int> columns;
    for (std::size_t i = 0; i < places.size(); ++i) {
        columns.push_back(history.addColumn(Precision::Exact));
    }
    std::vector<SeriesBuffer::Row> rows;
    rows.reserve(inputs.times.size());
    for (const double time : inputs.times) {
        rows.push_back({time, false});
    }
    for (const recording::RecordedGap& gap : file_.gaps()) {
        if (gap.row >= first && gap.row - first < rows.size()) {
            rows[gap.row - first].gapBefore = true;
        }
    }
    history.appendRows(
        rows, [&](std::size_t column, std::size_t row) { return inputs.values[places[column]][row]; });
    std::vector<double> values;
    values.reserve(rows.size());
    for (std::int64_t sample = 0; sample < history.end(); ++sample) {
        values.push_back(derivations_[signal]->valueAt(history, columns, sample));
    }
    return values;
}

Result<void> RecordedRows::readAll(recording::RowRange range, const CancelToken& cancel,
                                   const std::function<bool(std::uint64_t, const Rows&)>& each) {
    const std::uint64_t end = range.first + range.count;
    const bool looksFar = lookBack_ > file_.period() * static_cast<double>(kRowsAtATime);
    const std::uint64_t atATime = looksFar ? kRowsWithLookBack : kRowsAtATime;
    for (std::uint64_t at = range.first; at < end;) {
        if (cancel.isCancelled()) {
            return Error{ErrorCode::Cancelled, QStringLiteral("read %1").arg(file_.path()), {}};
        }
        // Steps end at multiples of the step size, which aligns them with the blocks.
        const std::uint64_t next = std::min(end, (at / atATime + 1) * atATime);
        const Result<Rows> rows = read({at, next - at});
        if (!rows) {
            return rows.error();
        }
        if (!each(at, *rows)) {
            break;
        }
        at = next;
    }
    return {};
}

Result<void> RecordedStretch::readAll(
    const CancelToken& cancel,
    const std::function<bool(std::uint64_t, const RecordedRows::Rows&)>& each) const {
    const auto file = recording::openRecording(path);
    if (!file) {
        return file.error();
    }
    if ((*file)->rows() < rows.first + rows.count || (*file)->startUtcNs() != startUtcNs ||
        (*file)->columns().size() != columns) {
        return Error{ErrorCode::FileNotReadable, path,
                     QStringLiteral("the file was replaced by another file")};
    }
    const qsizetype before = (*file)->problems().size();
    auto read = RecordedRows(**file, begin, wanted).readAll(rows, cancel, each);
    if (read && (*file)->problems().size() > before) {
        return Error{ErrorCode::FileCorrupt, path, (*file)->problems().last()};
    }
    return read;
}

}  // namespace tiller
