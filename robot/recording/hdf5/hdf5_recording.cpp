// SPDX-License-Identifier: MIT
#include "robot/recording/hdf5/hdf5_recording.h"

#include <QFile>
#include <algorithm>
#include <array>
#include <cmath>

#include "robot/core/file_reading.h"
#include "robot/recording/detail/column_knowledge.h"
#include "robot/recording/detail/ranges.h"
#include "robot/recording/hdf5/detail/hdf5_handle.h"

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
    std::optional<double> missing;
};

herr_t collectName(hid_t, const char* name, const H5L_info_t*, void* names) {
    static_cast<std::vector<std::string>*>(names)->emplace_back(name);
    return static_cast<std::vector<std::string>*>(names)->size() < kMaxColumns ? 0 : 1;
}

std::optional<DataSet> openSet(hid_t file, const std::string& name) {
    DataSet out;
    out.name = name;
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
    if (extent[0] > kMaxRows || extent[1] > kMaxColumns || extent[1] == 0) {
        return std::nullopt;
    }
    out.rows = extent[0];
    out.numbers = rank == 2 ? static_cast<std::size_t>(extent[1]) : 1;
    out.whole = kind == H5T_INTEGER;
    out.missing = takeNumber(out.set.get(), "missing");
    return out;
}

class Hdf5Recording : public Recording {
public:
    explicit Hdf5Recording(const QString& path) : path_(path) {}

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
        H5Literate(file_.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, collectName, &names);
        std::vector<DataSet> sets;
        for (const std::string& name : names) {
            if (auto set = openSet(file_.get(), name)) {
                sets.push_back(std::move(*set));
            } else {
                problems_
                    << QStringLiteral("\"%1\" is skipped: it is not a table of numbers.").arg(Text(name));
            }
        }
        chooseSets(std::move(sets));
        if (columns_.empty()) {
            return Error{ErrorCode::FileCorrupt, path_,
                         QStringLiteral("its top level contains no tables of numbers")};
        }
        readAttributes();
        return readAxis();
    }

    const QString& path() const override { return path_; }
    QString format() const override { return QStringLiteral("HDF5"); }
    const std::vector<RecordedColumn>& columns() const override { return columns_; }
    std::uint64_t rows() const override { return rows_; }
    const std::vector<RecordedGap>& gaps() const override { return gaps_; }
    double period() const override { return period_; }
    std::optional<std::int64_t> startUtcNs() const override { return start_; }
    const std::map<std::string, std::string>& facts() const override { return facts_; }
    const QStringList& problems() const override { return problems_; }

    Result<std::vector<double>> times(RowRange range) const override {
        const RowRange part = within(range, rows_);
        if (!time_) {
            std::vector<double> out(static_cast<std::size_t>(part.count));
            for (std::size_t i = 0; i < out.size(); ++i) {
                out[i] = static_cast<double>(part.first + i) * period_;
            }
            return out;
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
        const hsize_t start[2] = {range.first, number};
        const hsize_t count[2] = {range.count, 1};
        const Handle here(H5Screate_simple(1, count, nullptr), H5Sclose);
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
        const std::string unit = takeText(set.set.get(), "unit").value_or("");
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
        if (const auto start = takeNumber(file_.get(), "start_utc_ns"); start && std::abs(*start) < 9e18) {
            start_ = static_cast<std::int64_t>(*start);
        }
        period_ = takeNumber(file_.get(), "period").value_or(0);
        period_ = std::isfinite(period_) && period_ > 0 ? period_ : 0.002;
        for (const char* key : {"model", "serial_number", "software", "robot", "written_by"}) {
            if (auto text = takeText(file_.get(), key)) {
                facts_[key] = std::move(*text);
            }
        }
    }

    Result<void> readAxis() {
        if (!time_) {
            for (std::size_t i = 0; i < columns_.size(); ++i) {
                if (columns_[i].name == "timestamp") {
                    time_ = openSet(file_.get(), "timestamp");
                }
            }
        }
        if (time_ && rows_ > 0) {
            const auto first = numbers(*time_, 0, {0, 1});
            if (!first) {
                return first.error();
            }
            timeStart_ = std::isfinite(first.value().front()) ? first.value().front() : 0;
        }
        return {};
    }

    QString path_;
    Handle file_;
    std::vector<DataSet> sets_;
    std::optional<DataSet> time_;
    double timeStart_ = 0;
    std::vector<RecordedColumn> columns_;
    std::vector<std::pair<std::size_t, std::size_t>> places_;  ///< data set and component within the data set
    std::uint64_t rows_ = 0;
    double period_ = 0.002;
    std::optional<std::int64_t> start_;
    std::map<std::string, std::string> facts_;
    std::vector<RecordedGap> gaps_;
    QStringList problems_;
};

}  // namespace

Result<std::unique_ptr<Recording>> openHdf5(const Text& path) {
    auto recording = std::make_unique<Hdf5Recording>(path);
    if (auto opened = recording->open(); !opened) {
        return opened.error();
    }
    return std::unique_ptr<Recording>(std::move(recording));
}

}  // namespace tiller::recording
