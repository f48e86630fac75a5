// SPDX-License-Identifier: MIT
#include "robot/recording/hdf5/hdf5_recording.h"

#include <QFile>
#include <algorithm>
#include <array>
#include <cmath>

#include "robot/core/file_reading.h"
#include "robot/recording/detail/column_knowledge.h"
#include "robot/recording/detail/ranges.h"
#include "robot/recording/detail/time_axis.h"
#include "robot/recording/hdf5/detail/hdf5_handle.h"
#include "robot/recording/hdf5/detail/hdf5_notes.h"

namespace tiller::recording {

namespace {

using namespace hdf5;

constexpr std::size_t kMaxColumns = 20'000;
constexpr std::uint64_t kMaxRows = 4'000'000'000;
constexpr std::uint64_t kMaxPerRequest = 64u << 20;  // maximum number of values in memory

struct DataSet {
    std::string name;
    Handle set;
    std::uint64_t rows = 0;
    std::size_t numbers = 1;
    bool whole = false;
    bool isTransposed = false;  ///< each row of the dataset contains one column of the recording
    std::optional<double> missing;
};

herr_t collectName(hid_t, const char* name, const H5L_info_t*, void* names) {
    static_cast<std::vector<std::string>*>(names)->emplace_back(name);
    return static_cast<std::vector<std::string>*>(names)->size() < kMaxColumns ? 0 : 1;
}

/// A group that Octave writes for a variable: its type, and its value in column order.
bool isOctaveVariable(hid_t file, const std::string& group) {
    return H5Lexists(file, (group + "/type").c_str(), H5P_DEFAULT) > 0 &&
           H5Lexists(file, (group + "/value").c_str(), H5P_DEFAULT) > 0;
}

bool isGroup(hid_t file, const std::string& name) {
    return static_cast<bool>(Handle(H5Gopen2(file, name.c_str(), H5P_DEFAULT), H5Gclose));
}

bool isEmptyGroup(hid_t file, const std::string& name) {
    H5G_info_t info{};
    return H5Gget_info_by_name(file, name.c_str(), &info, H5P_DEFAULT) >= 0 && info.nlinks == 0;
}

std::optional<DataSet> openSet(hid_t file, const std::string& name) {
    DataSet out;
    out.name = name;
    if (const std::size_t slash = name.rfind("/value"); slash != std::string::npos &&
                                                        slash + 6 == name.size() &&
                                                        isOctaveVariable(file, name.substr(0, slash))) {
        out.name = name.substr(0, slash);
        out.isTransposed = true;
    }
    out.set = Handle(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
    if (!out.set) {  // a group, or a broken link
        return std::nullopt;
    }
    const Handle type(H5Dget_type(out.set.get()), H5Tclose);
    const Handle space(H5Dget_space(out.set.get()), H5Sclose);
    if (!type || !space) {
        return std::nullopt;
    }
    const H5T_class_t kind = H5Tget_class(type.get());
    const int rank = H5Sget_simple_extent_ndims(space.get());
    if ((kind != H5T_FLOAT && kind != H5T_INTEGER) || rank < 1 || rank > 2) {
        return std::nullopt;
    }
    std::array<hsize_t, 2> extent{0, 1};
    H5Sget_simple_extent_dims(space.get(), extent.data(), nullptr);
    out.isTransposed = rank == 2 && (out.isTransposed || H5Aexists(out.set.get(), "MATLAB_class") > 0);
    out.rows = extent[out.isTransposed ? 1 : 0];
    out.numbers = rank == 2 ? static_cast<std::size_t>(extent[out.isTransposed ? 0 : 1]) : 1;
    // Octave and MATLAB write a vector as one row or as one column.
    if (out.isTransposed && out.rows == 1) {
        out.rows = out.numbers;
        out.numbers = 1;
        out.isTransposed = false;
    }
    if (out.rows > kMaxRows || out.numbers > kMaxColumns || out.numbers == 0) {
        return std::nullopt;
    }
    out.whole = kind == H5T_INTEGER;
    out.missing = takeNumber(out.set.get(), "missing");
    return out;
}

class Hdf5Recording : public Recording {
public:
    Hdf5Recording(const QString& path, const TableFormat& format) : path_(path), format_(format) {}

    Result<void> open() {
        // Check this first, because the HDF5 library would block on a pipe.
        QFile readable;
        if (const Result<void> opened = openForReading(readable, path_); !opened) {
            return opened;
        }
        readable.close();
        const Quiet quiet;
        file_ = Handle(H5Fopen(QFile::encodeName(path_).constData(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
        if (!file_) {
            return Error{ErrorCode::FileCorrupt, path_,
                         QStringLiteral("the file is not a complete HDF5 file")};
        }
        std::vector<std::string> names;
        H5Lvisit(file_.get(), H5_INDEX_NAME, H5_ITER_INC, collectName, &names);
        std::vector<DataSet> sets;
        const bool withNotes = hasNotes(file_.get());
        for (const std::string& name : names) {
            if (withNotes && isOfNotes(name)) {
                continue;
            }
            if (isGroup(file_.get(), name)) {
                if (isEmptyGroup(file_.get(), name)) {
                    problems_ << QStringLiteral("\"%1\" is skipped: it is empty.").arg(Text(name));
                }
            } else if (const std::size_t end = name.rfind('/');
                       end != std::string::npos && name.substr(end) == "/type" &&
                       isOctaveVariable(file_.get(), name.substr(0, end))) {
                continue;
            } else if (auto set = openSet(file_.get(), name)) {
                sets.push_back(std::move(*set));
            } else {
                problems_
                    << QStringLiteral("\"%1\" is skipped: it is not a table of numbers.").arg(Text(name));
            }
        }
        chooseSets(std::move(sets));
        if (columns_.empty()) {
            return Error{ErrorCode::FileCorrupt, path_,
                         QStringLiteral("the file contains no tables of numbers")};
        }
        readAttributes();
        if (const Result<void> read = readAxis(); !read) {
            return read;
        }
        events_ = line_.restarts;
        for (RecordedEvent& note : withNotes ? readNotes(file_.get()) : std::vector<RecordedEvent>()) {
            note.seconds -= timeStart_;
            events_.push_back(std::move(note));
        }
        std::stable_sort(events_.begin(), events_.end(), [](const RecordedEvent& a, const RecordedEvent& b) {
            return a.seconds < b.seconds;
        });
        return {};
    }

    const QString& path() const override { return path_; }
    QString format() const override { return QStringLiteral("HDF5"); }
    const std::vector<RecordedColumn>& columns() const override { return columns_; }
    std::uint64_t rows() const override { return rows_; }
    const std::vector<RecordedGap>& gaps() const override { return gaps_; }
    const std::vector<RecordedEvent>& events() const override { return events_; }
    double period() const override { return period_; }
    std::optional<std::size_t> timeColumn() const override {
        return isOwn_ ? Recording::timeColumn() : timeColumn_;
    }
    std::optional<std::int64_t> startUtcNs() const override { return start_; }
    const std::map<std::string, std::string>& facts() const override { return facts_; }
    const QStringList& problems() const override { return problems_; }

    Result<std::vector<double>> times(RowRange range) const override {
        const RowRange part = within(range, rows_);
        if (!isOwn_) {
            const auto first = line_.seconds.begin() + static_cast<std::ptrdiff_t>(part.first);
            return std::vector<double>(first, first + static_cast<std::ptrdiff_t>(part.count));
        }
        auto out = numbers(*time_, 0, part);
        if (out) {
            double last = -std::numeric_limits<double>::infinity();
            for (double& time : out.value()) {
                time = std::isfinite(time - timeStart_) ? std::max(time - timeStart_, last)
                                                        : std::max(last, 0.0);
                last = time;
            }
        }
        return out;
    }

    Result<std::vector<std::vector<double>>> read(std::span<const std::size_t> wanted,
                                                  RowRange range) const override {
        const RowRange part = within(range, rows_);
        std::vector<std::vector<double>> out;
        for (const std::size_t column : wanted) {
            const auto& [set, number] = places_.at(column);
            auto values = numbers(sets_[set], number, part);
            if (!values) {
                return values.error();
            }
            out.push_back(std::move(values).value());
        }
        return out;
    }

private:
    Result<std::vector<double>> numbers(const DataSet& set, std::size_t number, RowRange range) const {
        const Quiet quiet;
        std::vector<double> out(static_cast<std::size_t>(range.count));
        if (out.empty()) {
            return out;
        }
        const Handle there(H5Dget_space(set.set.get()), H5Sclose);
        const bool isTransposed = set.isTransposed;
        const hsize_t start[2] = {isTransposed ? number : range.first, isTransposed ? range.first : number};
        const hsize_t count[2] = {isTransposed ? 1 : range.count, isTransposed ? range.count : 1};
        const hsize_t total = range.count;
        const Handle here(H5Screate_simple(1, &total, nullptr), H5Sclose);
        if (H5Sselect_hyperslab(there.get(), H5S_SELECT_SET, start, nullptr, count, nullptr) < 0 ||
            H5Dread(set.set.get(), H5T_NATIVE_DOUBLE, here.get(), there.get(), H5P_DEFAULT, out.data()) < 0) {
            return Error{ErrorCode::FileCorrupt, path_,
                         QStringLiteral("\"%1\" cannot be read").arg(Text(set.name))};
        }
        if (set.missing) {
            std::replace(out.begin(), out.end(), *set.missing, std::nan(""));
        }
        return out;
    }

    /// Selects the data sets with the most common length.
    void chooseSets(std::vector<DataSet> sets) {
        std::map<std::uint64_t, std::size_t> votes;
        for (const DataSet& set : sets) {
            votes[set.rows] += set.name == "gaps" ? 0 : set.numbers;
        }
        std::size_t most = 0;
        for (const auto& [rows, count] : votes) {
            if (count >= most) {
                most = count;
                rows_ = rows;
            }
        }
        for (DataSet& set : sets) {
            if (set.name == "gaps" && set.numbers == 3) {
                readGaps(set);
            } else if (set.rows != rows_) {
                problems_ << QStringLiteral("\"%1\" is skipped: it has %2 rows, the others have %3.")
                                 .arg(Text(set.name))
                                 .arg(set.rows)
                                 .arg(rows_);
            } else if (set.name == "time" && set.numbers == 1) {
                time_ = std::move(set);
            } else {
                addColumns(std::move(set));
            }
        }
    }

    void addColumns(DataSet set) {
        const std::string unit = unitOfSet(set);
        for (std::size_t i = 0; i < set.numbers && columns_.size() < kMaxColumns; ++i) {
            RecordedColumn column;
            column.name = set.numbers > 1 ? set.name + '_' + std::to_string(i) : set.name;
            column.whole = set.whole;
            addKnowledge(column);
            if (column.unit.empty()) {
                column.unit = unit;
            }
            columns_.push_back(std::move(column));
            places_.emplace_back(sets_.size(), i);
        }
        sets_.push_back(std::move(set));
    }

    void readGaps(const DataSet& set) {
        constexpr std::uint64_t kMaxGaps = 1'000'000;
        const RowRange all{0, std::min(set.rows, kMaxGaps)};
        const auto rows = numbers(set, 0, all);
        const auto packets = numbers(set, 1, all);
        const auto seconds = numbers(set, 2, all);
        for (std::size_t i = 0; rows && packets && seconds && i < rows.value().size(); ++i) {
            const double row = rows.value()[i];
            const double count = packets.value()[i];
            if (row >= 0 && row < 1e15 && count >= 0 && count < 1e15) {
                gaps_.push_back(
                    {static_cast<std::uint64_t>(row), static_cast<std::uint64_t>(count), seconds.value()[i]});
            }
        }
    }

    void readAttributes() {
        start_ = takeCount(file_.get(), "start_utc_ns");
        const auto period = takeNumber(file_.get(), "period");
        hasPeriod_ = period.has_value();
        period_ = period.value_or(0);
        period_ = std::isfinite(period_) && period_ > 0 ? period_ : 0;
        for (const std::string& key : attributeNames(file_.get())) {
            if (auto text = takeText(file_.get(), key.c_str())) {
                facts_[key] = std::move(*text);
            }
        }
    }

    Result<void> readAxis() {
        // Files of exportHdf5() have a period, and their time is read on demand.
        isOwn_ = hasPeriod_ && time_ && format_ == TableFormat{};
        if (isOwn_) {
            if (rows_ > 0) {
                const auto first = numbers(*time_, 0, {0, 1});
                if (!first) {
                    return first.error();
                }
                timeStart_ = std::isfinite(first.value().front()) ? first.value().front() : 0;
            }
            // A file with a part of a recording contains the start time of the whole recording.
            constexpr double kMaxSeconds = 1e9;
            if (start_ && std::abs(timeStart_) < kMaxSeconds) {
                *start_ += std::llround(timeStart_ * 1e9);
            }
            return {};
        }
        if (rows_ > kMaxPerRequest) {
            return Error{ErrorCode::FileCorrupt, path_, QStringLiteral("the file has too many rows")};
        }
        // The data set `time` is not one of the columns, but it can be the time axis.
        std::vector<RecordedColumn> candidates = columns_;
        if (time_) {
            candidates.push_back({"time", unitOfSet(*time_), false});
        }
        const auto valuesOf = [this](std::size_t column) -> Result<std::vector<double>> {
            const RowRange all{0, rows_};
            if (column == columns_.size()) {
                return numbers(*time_, 0, all);
            }
            const auto& [set, number] = places_[column];
            return numbers(sets_[set], number, all);
        };
        TableFormat format = format_;
        if (!format.timeColumn && format.rate == 0 && period_ > 0) {
            format.rate = 1 / period_;
        }
        const std::vector<DateKind> dates(candidates.size());
        const auto axis = chooseTimeAxis(path_, {candidates, dates, valuesOf}, format);
        if (!axis) {
            return axis.error();
        }
        std::vector<double> stamps;
        std::vector<double> nanoseconds;
        for (const auto& [column, values] :
             {std::pair(axis->column, &stamps), std::pair(axis->nanoseconds, &nanoseconds)}) {
            auto read = column ? valuesOf(*column) : Result<std::vector<double>>(std::vector<double>());
            if (!read) {
                return read.error();
            }
            *values = std::move(read).value();
        }
        line_ = timeLine(*axis, stamps, nanoseconds, static_cast<std::size_t>(rows_));
        period_ = line_.period;
        gaps_.insert(gaps_.end(), line_.breaks.begin(), line_.breaks.end());
        std::stable_sort(gaps_.begin(), gaps_.end(),
                         [](const RecordedGap& a, const RecordedGap& b) { return a.row < b.row; });
        start_ = start_ ? start_ : axis->startUtcNs;
        if (axis->column && *axis->column < columns_.size()) {
            timeColumn_ = axis->column;
        }
        return {};
    }

    static std::string unitOfSet(const DataSet& set) {
        const auto unit = takeText(set.set.get(), "unit");
        return unit ? *unit : takeText(set.set.get(), "units").value_or("");
    }

    QString path_;
    const TableFormat format_;
    Handle file_;
    std::vector<DataSet> sets_;
    std::optional<DataSet> time_;
    double timeStart_ = 0;
    bool hasPeriod_ = false;
    bool isOwn_ = false;
    TimeLine line_;                            ///< times of a file of another program
    std::optional<std::size_t> timeColumn_{};  ///< time column of a file of another program
    std::vector<RecordedColumn> columns_;
    std::vector<std::pair<std::size_t, std::size_t>> places_;  ///< data set and component within the data set
    std::uint64_t rows_ = 0;
    double period_ = 0;
    std::optional<std::int64_t> start_;
    std::map<std::string, std::string> facts_;
    std::vector<RecordedGap> gaps_;
    std::vector<RecordedEvent> events_;
    QStringList problems_;
};

}  // namespace

Result<std::unique_ptr<Recording>> openHdf5(const Text& path, const TableFormat& format) {
    auto recording = std::make_unique<Hdf5Recording>(path, format);
    if (auto opened = recording->open(); !opened) {
        return opened.error();
    }
    return std::unique_ptr<Recording>(std::move(recording));
}

}  // namespace tiller::recording
