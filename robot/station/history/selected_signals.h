// SPDX-License-Identifier: MIT
#pragma once

// Makes selected signals of a recording available as a recording with the same rows, for exports. The signals
// can be columns of the file, single bits, and computed signals.

#include <vector>

#include "robot/recording/recording.h"
#include "robot/station/history/recorded_rows.h"

namespace tiller {

/// The first column is the time column of the file or, without a time column, `seconds` since the first row.
class SelectedSignals : public recording::Recording {
public:
    struct Column {
        recording::RecordedColumn column;
        RecordedSignal signal;
    };
    /// file     must outlive the object
    /// columns  columns except the time column, which is added automatically
    SelectedSignals(const recording::Recording& file, const std::vector<Column>& columns);
    /// Adds an event that the file does not contain.
    void add(recording::RecordedEvent event);

    const QString& path() const override { return file_.path(); }
    QString format() const override { return file_.format(); }
    const std::vector<recording::RecordedColumn>& columns() const override { return columns_; }
    std::uint64_t rows() const override { return file_.rows(); }
    const std::vector<recording::RecordedGap>& gaps() const override { return file_.gaps(); }
    const std::vector<recording::RecordedEvent>& events() const override { return events_; }
    double period() const override { return file_.period(); }
    std::optional<std::int64_t> startUtcNs() const override { return file_.startUtcNs(); }
    const std::map<std::string, std::string>& facts() const override { return file_.facts(); }
    const QStringList& problems() const override { return file_.problems(); }
    const std::vector<recording::RowRange>& unreadable() const override { return file_.unreadable(); }
    Result<std::vector<double>> times(recording::RowRange rows) const override { return file_.times(rows); }
    // Overrides of Recording.
    Result<std::vector<std::vector<double>>> read(std::span<const std::size_t> columns,
                                                  recording::RowRange rows) const override;
    Result<std::uint64_t> rowAt(double seconds) const override { return file_.rowAt(seconds); }

private:
    const recording::Recording& file_;
    std::vector<recording::RecordedColumn> columns_;
    std::vector<recording::RecordedEvent> events_;
    std::vector<RecordedSignal> signals_;  ///< one per column; the time column has no source columns
};

}  // namespace tiller
