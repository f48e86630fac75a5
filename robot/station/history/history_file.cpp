// SPDX-License-Identifier: MIT
#include "robot/station/history/history_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace tiller {

namespace {

constexpr std::int64_t kBlock = SeriesColumn::kBlockRows;
/// Recordings with up to this number of rows (two minutes at 500 Hz) are read faster as a whole than in
/// parts.
constexpr std::uint64_t kShort = 60'000;
/// Ranges of up to this number of rows are read completely in the first call.
constexpr std::int64_t kRowsAtOnce = 8'000;
/// Ranges of up to this number of rows are read completely by later calls; longer ranges are drawn from
/// extents.
constexpr std::int64_t kRowsInTheEnd = 64'000;
constexpr std::int64_t kBlocksInTurn = 1;
constexpr std::int64_t kExtentsInTurn = 1500;
constexpr std::int64_t kDraftColumns = 4;
/// Minimum number of extents for the first drawing of a long recording.
constexpr std::int64_t kMinExtents = 1000;
/// Maximum number of blocks whose rows are kept in memory.
constexpr std::size_t kBlocksKept = 64;

/// The time marks of the file, and two more at each gap, because a gap contains no rows.
std::vector<SeriesBuffer::Mark> marksOf(const recording::Recording& file,
                                        const std::vector<recording::TimeMark>& known, double begin) {
    std::vector<SeriesBuffer::Mark> marks;
    auto gap = file.gaps().begin();
    for (const recording::TimeMark& mark : known) {
        const auto sample = static_cast<std::int64_t>(mark.row);
        double time = begin + mark.seconds;
        for (; gap != file.gaps().end() && gap->row <= mark.row; ++gap) {
            const auto behind = static_cast<std::int64_t>(gap->row);
            if (marks.empty() || behind <= marks.back().sample) {
                continue;
            }
            const SeriesBuffer::Mark last = marks.back();
            const double before =
                std::min(time, last.time + static_cast<double>(behind - 1 - last.sample) * file.period());
            if (behind - 1 > last.sample) {
                marks.push_back({behind - 1, before});
            }
            if (behind < sample) {
                marks.push_back({behind, std::min(time, before + gap->seconds)});
            } else {
                // The chunk of this mark may begin with a log entry from within the gap, before the first row
                // of the chunk.
                time = std::max(time, before + gap->seconds);
            }
        }
        if (marks.empty() || sample > marks.back().sample) {
            marks.push_back({sample, std::max(time, marks.empty() ? begin : marks.back().time)});
        }
    }
    return marks;
}

}  // namespace

bool HistoryFile::benefitsFromSummaries(const recording::Recording& file) {
    const std::vector<std::uint64_t> kept = file.summaryRows();
    const auto keeps = [&kept](std::int64_t rows) {
        return std::find(kept.begin(), kept.end(), static_cast<std::uint64_t>(rows)) != kept.end();
    };
    return file.rows() > kShort && keeps(SeriesColumn::kSummary);
}

Result<std::unique_ptr<HistoryFile>> HistoryFile::make(const recording::Recording& file,
                                                       SeriesBuffer& history, double begin) {
    const auto known = file.timeMarks();
    if (!known) {
        return known.error();
    }
    std::unique_ptr<HistoryFile> made(new HistoryFile(file, history, begin));
    std::vector<std::int64_t> gaps;
    for (const recording::RecordedGap& gap : file.gaps()) {
        gaps.push_back(static_cast<std::int64_t>(gap.row));
    }
    std::sort(gaps.begin(), gaps.end());
    for (const std::uint64_t rows : file.summaryRows()) {
        const auto each = static_cast<std::int64_t>(rows);
        if (each % SeriesColumn::kSummary == 0 && (kBlock % each == 0 || each % kBlock == 0) &&
            static_cast<std::int64_t>(file.rows()) / each >= kMinExtents) {
            made->levels_.push_back(each);
        }
    }
    if (made->levels_.empty()) {
        made->levels_.push_back(SeriesColumn::kSummary);
    }
    history.lieIn(*made, static_cast<std::int64_t>(file.rows()), marksOf(file, *known, begin),
                  std::move(gaps));
    return made;
}

std::int64_t HistoryFile::blocks() const {
    return (history_.end() + kBlock - 1) / kBlock;
}

Result<void> HistoryFile::readExtents(std::span<const Column> columns, recording::RowRange range,
                                      std::int64_t rowsEach) {
    std::vector<std::size_t> wanted;
    for (const Column& column : columns) {
        wanted.push_back(column.file);
    }
    // The file returns its stored extents for this number of rows, or finer extents if a crash prevented
    // storing them.
    const auto each = static_cast<std::uint64_t>(rowsEach);
    const auto read = file_.summaries(wanted, range, std::max<std::uint64_t>(1, range.count / each));
    if (!read) {
        return read.error();
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const recording::ColumnSummary& summary = (*read)[i];
        if (summary.firstRow != range.first || each % summary.rowsEach != 0) {
            return readExtentsOfRows(columns, range, rowsEach);
        }
        std::vector<MinMax> extents((range.count + each - 1) / each);
        for (std::size_t k = 0; k < summary.min.size(); ++k) {
            const std::size_t at = k * summary.rowsEach / each;
            if (at < extents.size() && !std::isnan(summary.min[k])) {
                extents[at].add(MinMax{summary.min[k], summary.max[k]});
            }
        }
        history_.setExtents(columns[i].column, static_cast<std::int64_t>(range.first), rowsEach, extents);
    }
    return {};
}

Result<void> HistoryFile::readExtentsOfRows(std::span<const Column> columns, recording::RowRange range,
                                            std::int64_t rowsEach) {
    constexpr std::uint64_t kAtOnce = 16 * static_cast<std::uint64_t>(kBlock);
    std::vector<std::size_t> wanted;
    for (const Column& column : columns) {
        wanted.push_back(column.file);
    }
    for (std::uint64_t done = 0; done < range.count; done += kAtOnce) {
        const recording::RowRange part{range.first + done, std::min(kAtOnce, range.count - done)};
        const auto rows = file_.read(wanted, part);
        if (!rows) {
            return rows.error();
        }
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const auto each = static_cast<std::size_t>(rowsEach);
            std::vector<MinMax> extents((part.count + each - 1) / each);
            for (std::size_t row = 0; row < (*rows)[i].size(); ++row) {
                extents[row / each].add((*rows)[i][row]);
            }
            history_.setExtents(columns[i].column, static_cast<std::int64_t>(part.first), rowsEach, extents);
        }
    }
    return {};
}

Result<std::vector<int>> HistoryFile::add(std::span<const std::size_t> fileColumns,
                                          std::span<const Precision> precisions) {
    std::vector<Column> added;
    std::vector<int> numbers;
    for (std::size_t i = 0; i < fileColumns.size(); ++i) {
        numbers.push_back(history_.outlineColumn(precisions[i]));
        added.push_back({numbers.back(), fileColumns[i]});
    }
    columns_.insert(columns_.end(), added.begin(), added.end());
    const auto read = readExtents(added, {0, file_.rows()}, levels_.back());
    if (!read) {
        return read.error();
    }
    forgetRows();
    return numbers;
}

int HistoryFile::addComputed(const RecordedSignal& signal) {
    const int column = history_.outlineColumn(Precision::Single);
    computed_.push_back({column, RecordedRows(file_, begin_, {signal})});
    forgetRows();
    return column;
}

void HistoryFile::forgetRows() {
    for (const std::int64_t block : filled_) {
        history_.forget(block);
    }
    filled_.clear();
}

bool HistoryFile::isFilled(std::int64_t block) const {
    return std::all_of(columns_.begin(), columns_.end(), [&](const Column& column) {
        return history_.resolutionOf(column.column, block) == 1;
    });
}

std::int64_t HistoryFile::resolutionOf(std::int64_t block) const {
    std::int64_t grain = 1;
    for (const Column& column : columns_) {
        grain = std::max(grain, history_.resolutionOf(column.column, block));
    }
    return grain;
}

void HistoryFile::fill(std::int64_t block) {
    const recording::RowRange range{
        static_cast<std::uint64_t>(block * kBlock),
        static_cast<std::uint64_t>(std::min(kBlock, history_.end() - block * kBlock))};
    auto times = file_.times(range);
    std::vector<std::size_t> wanted;
    for (const Column& column : columns_) {
        wanted.push_back(column.file);
    }
    auto rows = file_.read(wanted, range);
    if (!times || !rows) {
        problem_ = (times ? rows.error() : times.error()).toString();
    }
    constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> axis =
        axisOf(times ? std::move(times).value() : std::vector<double>(), begin_, range.count);
    for (const recording::RowRange& missing : file_.unreadable()) {
        history_.addGap(static_cast<std::int64_t>(missing.first + missing.count));
    }
    history_.setTimes(block, axis);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        std::vector<double> values = rows ? std::move((*rows)[i]) : std::vector<double>();
        values.resize(static_cast<std::size_t>(range.count), kNoValue);
        history_.setRows(columns_[i].column, block, values);
    }
    for (Computed& computed : computed_) {
        const auto values = computed.rows.read(range);
        history_.setRows(computed.column, block,
                         values ? values->values.front()
                                : std::vector<double>(static_cast<std::size_t>(range.count), kNoValue));
    }
    filled_.remove(block);
    filled_.push_front(block);
    if (filled_.size() > kBlocksKept) {
        history_.forget(filled_.back());
        filled_.pop_back();
    }
}

bool HistoryFile::readExtents(std::int64_t first, std::int64_t last, std::int64_t rowsEach,
                              std::int64_t mostExtents) {
    while (first <= last && resolutionOf(first) <= rowsEach) {
        ++first;
    }
    while (first <= last && resolutionOf(last) <= rowsEach) {
        --last;
    }
    first -= rowsEach > kBlock ? first % (rowsEach / kBlock) : 0;
    if (first > last) {
        return false;
    }
    last = std::min(last, first + std::max<std::int64_t>(1, mostExtents * rowsEach / kBlock) - 1);
    const std::int64_t rows = std::min((last + 1) * kBlock, history_.end()) - first * kBlock;
    const auto read = readExtents(
        columns_, {static_cast<std::uint64_t>(first * kBlock), static_cast<std::uint64_t>(rows)}, rowsEach);
    if (!read) {
        problem_ = read.error().toString();
        return false;
    }
    return true;
}

bool HistoryFile::sharpen(std::int64_t begin, std::int64_t end, int pixelColumns, Effort effort) {
    begin = std::max<std::int64_t>(begin, 0);
    end = std::min(end, history_.end());
    if (begin >= end || columns_.empty()) {
        return false;
    }
    const std::int64_t rows = end - begin;
    const std::int64_t first = begin / kBlock;
    const std::int64_t last = (end - 1) / kBlock;
    const auto fillSome = [&](std::int64_t most) {
        for (std::int64_t block = first; block <= last; ++block) {
            if (!isFilled(block)) {
                if (most-- == 0) {
                    return true;
                }
                fill(block);
            }
        }
        return false;
    };
    if (rows <= kRowsAtOnce) {
        return fillSome(std::numeric_limits<std::int64_t>::max());
    }
    const std::int64_t perColumn = rows / std::max(pixelColumns, 1);
    const auto coarsest = [&](std::int64_t most) {
        std::int64_t found = levels_.front();
        for (const std::int64_t level : levels_) {
            found = level <= most ? level : found;
        }
        return found;
    };
    const std::int64_t wanted = coarsest(perColumn);
    if (effort == Effort::Draft) {
        // For the first drawing, an extent may span several pixel columns. The next calls read finer extents.
        readExtents(first, last, coarsest(kDraftColumns * perColumn),
                    std::numeric_limits<std::int32_t>::max());
        for (std::int64_t block = first; block <= last; ++block) {
            if (resolutionOf(block) > wanted || (rows <= kRowsInTheEnd && !isFilled(block))) {
                return true;
            }
        }
        return false;
    }
    if (readExtents(first, last, wanted, kExtentsInTurn)) {
        return true;
    }
    return rows <= kRowsInTheEnd && fillSome(kBlocksInTurn);
}

}  // namespace tiller
