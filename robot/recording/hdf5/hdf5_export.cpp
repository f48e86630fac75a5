// SPDX-License-Identifier: MIT
#include "robot/recording/hdf5/hdf5_export.h"

#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <string>

#include "robot/core/atomic_file.h"
#include "robot/recording/detail/exported_events.h"
#include "robot/recording/hdf5/detail/hdf5_handle.h"
#include "robot/recording/hdf5/detail/hdf5_notes.h"
#include "robot/rtde/fields.h"

namespace tiller::recording {

namespace {

using namespace hdf5;

constexpr std::uint64_t kRowsAtOnce = 4096;

struct Storage {
    hid_t type;      ///< type in the file
    double missing;  ///< value for missing numbers; NaN if the type has one
};

Storage storageOf(rtde::DataType type) {
    switch (type) {
        case rtde::DataType::Bool:
        case rtde::DataType::UInt8:
            return {H5T_STD_U8LE, 255};
        case rtde::DataType::UInt32:
        case rtde::DataType::Vector6UInt32:
            return {H5T_STD_U32LE, 4294967295.0};
        case rtde::DataType::Int32:
        case rtde::DataType::Vector6Int32:
            return {H5T_STD_I32LE, 2147483647.0};
        case rtde::DataType::UInt64:
            return {H5T_STD_U64LE, 9007199254740991.0};  // 2^53 - 1; up to this value, all integers are exact
                                                         // as doubles
        default:
            return {H5T_IEEE_F64LE, std::nan("")};
    }
}

/// A field with its columns in the recording, in order.
struct Field {
    std::string name;
    std::vector<std::size_t> columns;
    Storage storage{H5T_IEEE_F64LE, std::nan("")};
    std::string unit;
    std::string meaning;
    Handle set;
    bool hasMissing = false;
};

/// Names are from a file, so they may be duplicate, empty, or special in HDF5.
void makeNamesUsable(std::vector<Field>& fields) {
    // Names written in addition to the fields.
    std::set<std::string> used{"time", "gaps", "notes"};
    for (Field& field : fields) {
        std::string name = field.name;
        // A slash would create a group, and names consisting of dots refer to groups.
        std::replace(name.begin(), name.end(), '/', '_');
        if (name.find_first_not_of('.') == std::string::npos) {
            std::replace(name.begin(), name.end(), '.', '_');
        }
        if (name.empty()) {
            name = "unnamed";
        }
        field.name = name;
        for (int number = 2; !used.insert(field.name).second; ++number) {
            field.name = name + " (" + std::to_string(number) + ")";
        }
    }
}

/// Returns true if the columns begin with all components of a field, in order. These are combined into one
/// field. Single components are not written under the name of the field.
bool hasAllComponents(const Recording& recording, std::span<const std::size_t> columns,
                      const rtde::Field& field) {
    const std::size_t count = rtde::componentCount(field.type);
    for (std::size_t i = 0; i < count; ++i) {
        if (i >= columns.size() ||
            recording.columns()[columns[i]].name != std::string(field.name) + '_' + std::to_string(i)) {
            return false;
        }
    }
    return count > 1;
}

std::vector<Field> fieldsOf(const Recording& recording, const std::vector<std::size_t>& columns) {
    std::vector<Field> fields;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const std::size_t column = columns[i];
        const RecordedColumn& described = recording.columns()[column];
        const std::string& name = described.name;
        const std::size_t bar = name.rfind('_');
        const bool numbered = bar != std::string::npos && bar + 2 == name.size();
        const rtde::Field* single = rtde::findOutput(name);
        const rtde::Field* vector =
            single == nullptr && numbered ? rtde::findOutput(std::string_view(name).substr(0, bar)) : nullptr;
        if (vector != nullptr && hasAllComponents(recording, std::span(columns).subspan(i), *vector)) {
            const std::size_t count = rtde::componentCount(vector->type);
            Field& field = fields.emplace_back();
            field.columns.assign(columns.begin() + static_cast<std::ptrdiff_t>(i),
                                 columns.begin() + static_cast<std::ptrdiff_t>(i + count));
            field.name = vector->name;
            field.storage = storageOf(vector->type);
            field.unit = vector->unit;
            field.meaning = vector->meaning;
            i += count - 1;
            continue;
        }
        Field& field = fields.emplace_back();
        field.columns = {column};
        field.name = name;
        field.unit = described.unit;
        if (const rtde::Field* known = single != nullptr ? single : vector) {
            field.storage = storageOf(known->type);
            field.meaning = known->meaning;
            field.unit = single != nullptr ? known->unit : described.unit;
        } else if (described.whole) {
            field.storage = storageOf(rtde::DataType::UInt64);
        }
    }
    makeNamesUsable(fields);
    return fields;
}

Handle makeSet(hid_t file, const std::string& name, hid_t type, std::uint64_t rows, std::size_t numbers) {
    const hsize_t extent[2] = {rows, numbers};
    const int rank = numbers > 1 ? 2 : 1;
    const Handle space(H5Screate_simple(rank, extent, nullptr), H5Sclose);
    return {H5Dcreate2(file, name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
            H5Dclose};
}

bool putRows(const Handle& set, std::uint64_t from, std::uint64_t rows, std::size_t numbers,
             const std::vector<double>& values) {
    const hsize_t start[2] = {from, 0};
    const hsize_t count[2] = {rows, numbers};
    const int rank = numbers > 1 ? 2 : 1;
    const Handle there(H5Dget_space(set.get()), H5Sclose);
    const Handle here(H5Screate_simple(rank, count, nullptr), H5Sclose);
    return H5Sselect_hyperslab(there.get(), H5S_SELECT_SET, start, nullptr, count, nullptr) >= 0 &&
           H5Dwrite(set.get(), H5T_NATIVE_DOUBLE, here.get(), there.get(), H5P_DEFAULT, values.data()) >= 0;
}

class Exporter {
public:
    Exporter(const Recording& recording, const ExportChoice& choice, QString path)
        : recording_(recording), choice_(choice), path_(std::move(path)) {}

    Result<ExportReport> run() {
        const auto columns = chooseColumns(recording_, choice_.columns);
        if (!columns) {
            return columns.error();
        }
        const auto rows = chooseRows(recording_, choice_);
        if (!rows) {
            return rows.error();
        }
        const Quiet quiet;
        rows_ = rows.value();
        fields_ = fieldsOf(recording_, columns.value());
        file_ =
            Handle(H5Fcreate(QFile::encodeName(path_).constData(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT),
                   H5Fclose);
        if (!file_ || !begin()) {
            return failure();
        }
        if (auto written = writeRows(); !written) {
            return written.error();
        }
        const auto events = exportedEvents(recording_, choice_, rows_);
        if (!events) {
            return events.error();
        }
        if (!writeGaps() || !writeNotes(file_.get(), *events) || !finish()) {
            return failure();
        }
        ExportReport report;
        report.rows = rows_.count;
        report.bytes = QFileInfo(path_).size();
        return report;
    }

private:
    Error failure() const {
        const bool full = errno == ENOSPC || errno == EDQUOT;
        return {full ? ErrorCode::DiskFull : ErrorCode::FileNotWritable, choice_.path,
                full ? qt_error_string(errno) : QStringLiteral("the file cannot be written to this folder")};
    }

    bool begin() {
        bool ok = putNumber(file_.get(), "period", recording_.period());
        if (const auto start = recording_.startUtcNs()) {
            ok = ok && putCount(file_.get(), "start_utc_ns", static_cast<std::uint64_t>(*start));
        }
        for (const auto& [key, value] : recording_.facts()) {
            // A recording that was exported before already has these attributes.
            ok = ok && (key.empty() || H5Aexists(file_.get(), key.c_str()) > 0 ||
                        putText(file_.get(), key.c_str(), value));
        }
        time_ = makeSet(file_.get(), "time", H5T_IEEE_F64LE, rows_.count, 1);
        ok = ok && time_ && putText(time_.get(), "unit", "s") &&
             putText(time_.get(), "meaning", "time since the first row of the recording");
        for (Field& field : fields_) {
            field.set =
                makeSet(file_.get(), field.name, field.storage.type, rows_.count, field.columns.size());
            ok = ok && field.set && putText(field.set.get(), "unit", field.unit) &&
                 putText(field.set.get(), "meaning", field.meaning);
        }
        return ok;
    }

    Result<void> writeRows() {
        std::vector<std::size_t> all;
        for (const Field& field : fields_) {
            all.insert(all.end(), field.columns.begin(), field.columns.end());
        }
        std::vector<double> block;
        for (std::uint64_t done = 0; done < rows_.count; done += kRowsAtOnce) {
            if (choice_.progress &&
                !choice_.progress(static_cast<double>(done) / static_cast<double>(rows_.count))) {
                return Error{ErrorCode::Cancelled, QStringLiteral("export to %1").arg(choice_.path), {}};
            }
            const RowRange part{rows_.first + done, std::min(kRowsAtOnce, rows_.count - done)};
            const auto times = recording_.times(part);
            const auto values = recording_.read(all, part);
            if (!times || !values) {
                return times ? values.error() : times.error();
            }
            bool ok = putRows(time_, done, part.count, 1, times.value());
            std::size_t first = 0;
            for (Field& field : fields_) {
                const std::size_t numbers = field.columns.size();
                block.resize(static_cast<std::size_t>(part.count) * numbers);
                for (std::size_t i = 0; i < numbers; ++i) {
                    const std::vector<double>& column = values.value()[first + i];
                    for (std::size_t row = 0; row < part.count; ++row) {
                        const bool missing = std::isnan(column[row]);
                        field.hasMissing = field.hasMissing || missing;
                        block[row * numbers + i] = missing ? field.storage.missing : column[row];
                    }
                }
                ok = ok && putRows(field.set, done, part.count, numbers, block);
                first += numbers;
            }
            if (!ok) {
                return failure();
            }
        }
        return {};
    }

    bool writeGaps() {
        std::vector<double> table;
        for (const RecordedGap& gap : recording_.gaps()) {
            if (gap.row >= rows_.first && gap.row < rows_.first + rows_.count) {
                table.insert(table.end(), {static_cast<double>(gap.row - rows_.first),
                                           static_cast<double>(gap.packets), gap.seconds});
            }
        }
        constexpr std::size_t kNumbers = 3;
        const std::uint64_t count = table.size() / kNumbers;
        const Handle set = makeSet(file_.get(), "gaps", H5T_IEEE_F64LE, count, kNumbers);
        return set &&
               putText(set.get(), "meaning",
                       "packets missing before a row: row, number of packets, duration [s]") &&
               (count == 0 || putRows(set, 0, count, kNumbers, table));
    }

    bool finish() {
        bool ok = time_.reset();
        for (Field& field : fields_) {
            if (field.hasMissing && !std::isnan(field.storage.missing)) {
                ok = putNumber(field.set.get(), "missing", field.storage.missing) && ok;
            }
            ok = field.set.reset() && ok;
        }
        return file_.reset() && ok;
    }

    const Recording& recording_;
    const ExportChoice& choice_;
    const QString path_;
    RowRange rows_;
    Handle file_;
    Handle time_;
    std::vector<Field> fields_;
};

}  // namespace

Result<ExportReport> exportHdf5(const Recording& recording, const ExportChoice& choice) {
    // Write to a temporary file first, so that an existing file is replaced completely or not at all.
    const QString part = choice.path + QStringLiteral(".part");
    const auto report = Exporter(recording, choice, part).run();
    if (!report) {
        QFile::remove(part);
        return report;
    }
    const Result<void> replaced = replaceFile(part, choice.path);
    if (!replaced) {
        QFile::remove(part);
        return replaced.error();
    }
    return report;
}

}  // namespace tiller::recording
