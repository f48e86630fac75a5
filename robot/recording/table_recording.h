// SPDX-License-Identifier: MIT
#pragma once

// A recording with all values in memory, e.g. read from a text file.

#include <optional>
#include <utility>

#include "robot/recording/metadata.h"
#include "robot/recording/recording.h"
#include "robot/recording/table_format.h"

namespace tiller::recording {

/// Content of a table. `columns` describes `values`; all columns have the same length.
struct RecordedTable {
    QString path{};
    QString format{};
    std::vector<RecordedColumn> columns{};
    std::vector<std::vector<double>> values{};
    QStringList problems{};
    /// Each note with the number of rows before it, which determines its time.
    std::vector<std::pair<std::uint64_t, RecordedEvent>> notes{};
    Metadata facts{};
    std::optional<std::int64_t> startUtcNs{};  ///< used if the time stamps are not dates
    /// Empty: the column `timestamp`, or the first column named time, seconds or t, in seconds.
    std::optional<TimeAxis> axis{};
};

/// If the clock was reset, the time continues from its last value, and events() reports the reset. Gaps are
/// taken from the column `packages_lost`, or detected where two rows are more than one and a half periods
/// apart. A gap of an unknown number of packets separates two segments.
class TableRecording : public Recording {
public:
    explicit TableRecording(RecordedTable table);

    const QString& path() const override { return table_.path; }
    QString format() const override { return table_.format; }
    const std::vector<RecordedColumn>& columns() const override { return table_.columns; }
    std::uint64_t rows() const override { return times_.size(); }
    const std::vector<RecordedGap>& gaps() const override { return gaps_; }
    const std::vector<RecordedEvent>& events() const override { return events_; }
    double period() const override { return period_; }
    std::optional<std::size_t> timeColumn() const override { return table_.axis->column; }
    std::optional<std::int64_t> startUtcNs() const override {
        return table_.axis->startUtcNs ? table_.axis->startUtcNs : table_.startUtcNs;
    }
    const Metadata& facts() const override { return table_.facts; }
    const QStringList& problems() const override { return table_.problems; }
    Result<std::vector<double>> times(RowRange rows) const override;
    // See Recording.
    Result<std::vector<std::vector<double>>> read(std::span<const std::size_t> columns,
                                                  RowRange rows) const override;

private:
    void findTimes();
    void findGaps(const std::vector<RecordedGap>& breaks);
    void addNotes();

    RecordedTable table_;
    std::vector<double> times_;
    double period_ = 0;
    std::vector<RecordedGap> gaps_;
    std::vector<RecordedEvent> events_;
};

}  // namespace tiller::recording
