// SPDX-License-Identifier: MIT
#include "robot/recording/export.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>

#include "robot/core/atomic_file.h"
#include "robot/recording/detail/column_knowledge.h"
#include "robot/recording/detail/csv_head.h"
#include "robot/recording/detail/csv_notes.h"
#include "robot/recording/detail/exported_events.h"
#include "robot/recording/detail/ranges.h"
#include "robot/recording/detail/restart_note.h"

namespace tiller::recording {

namespace {

constexpr std::uint64_t kRowsAtOnce = 512;  // with this number of rows, all columns fit into the cache
constexpr std::size_t kMaxNumber = 32;

bool belongsTo(std::string_view column, std::string_view field) {
    if (column == field) {
        return true;
    }
    return column.size() == field.size() + 2 && column.starts_with(field) && column[field.size()] == '_' &&
           column.back() >= '0' && column.back() <= '9';
}

/// Writes at `at`, which must have enough space.
/// Returns  the end of the written text
char* putNumber(char* at, double value, bool whole, char decimal) {
    if (std::isnan(value)) {
        return at;
    }
    constexpr double kExact = 9007199254740992.0;  // 2^53
    if (whole && std::abs(value) < kExact && value == std::trunc(value)) {
        return std::to_chars(at, at + kMaxNumber, static_cast<std::int64_t>(value)).ptr;
    }
    char* const end = std::to_chars(at, at + kMaxNumber, value).ptr;
    if (decimal != '.') {
        std::replace(at, end, '.', decimal);
    }
    return end;
}

template <class Number>
std::string shortest(Number value) {
    if (std::isnan(value)) {
        return {};
    }
    char text[kMaxNumber];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace

std::string csvCell(std::string_view text, char separator) {
    const char special[] = {separator, '"', '\n', '\r', '\0'};
    std::string out(text);
    if (text.find_first_of(special) == std::string_view::npos) {
        return out;
    }
    for (std::size_t at = out.find('"'); at != std::string::npos; at = out.find('"', at + 2)) {
        out.insert(at, 1, '"');
    }
    return '"' + out + '"';
}

std::string csvNumber(double value) {
    return shortest(value);
}

std::string csvNumber(float value) {
    return shortest(value);
}

Result<std::vector<std::size_t>> chooseColumns(const Recording& recording,
                                               const std::vector<std::string>& names) {
    std::vector<std::size_t> chosen;
    const auto& columns = recording.columns();
    if (names.empty()) {
        for (std::size_t i = 0; i < columns.size(); ++i) {
            chosen.push_back(i);
        }
        return chosen;
    }
    QStringList missing;
    for (const std::string& name : names) {
        bool found = false;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            if (belongsTo(columns[i].name, name)) {
                found = true;
                if (std::find(chosen.begin(), chosen.end(), i) == chosen.end()) {
                    chosen.push_back(i);
                }
            }
        }
        if (!found) {
            missing << QStringLiteral("the recording has no column \"%1\"").arg(Text(name));
        }
    }
    if (!missing.isEmpty()) {
        return Error{ErrorCode::FieldUnknown, recording.path(), missing.join(QStringLiteral("; "))};
    }
    return chosen;
}

std::optional<std::size_t> timeColumn(const Recording& recording) {
    return recording.timeColumn();
}

Result<std::vector<std::size_t>> columnsWithTime(const Recording& recording,
                                                 const std::vector<std::string>& names) {
    auto chosen = chooseColumns(recording, names);
    const auto time = timeColumn(recording);
    if (chosen && time && std::find(chosen->begin(), chosen->end(), *time) == chosen->end()) {
        chosen->insert(chosen->begin(), *time);
    }
    return chosen;
}

Result<RowRange> chooseRows(const Recording& recording, const ExportChoice& choice) {
    if (recording.rows() == 0) {
        return RowRange{};
    }
    const auto first = choice.from <= 0 ? Result<std::uint64_t>(0) : recording.rowAt(choice.from);
    const auto last = std::isinf(choice.until) ? Result<std::uint64_t>(recording.rows() - 1)
                                               : recording.rowAt(choice.until);
    if (!first || !last) {
        return first ? last.error() : first.error();
    }
    RowRange range{first.value(), 0};
    // For a time between two rows, rowAt() returns the earlier row.
    if (const auto time = recording.times({range.first, 1});
        time && !time.value().empty() && time.value().front() < choice.from) {
        ++range.first;
    }
    range.count =
        last.value() + 1 > range.first && choice.until >= choice.from ? last.value() + 1 - range.first : 0;
    return within(range, recording.rows());
}

namespace {

Result<void> exportNotes(const Recording& recording, const ExportChoice& choice, const RowRange& rows) {
    const auto events = exportedEvents(recording, choice, rows);
    if (!events) {
        return events.error();
    }
    const auto start = recording.startUtcNs();
    std::vector<RowNote> notes;
    for (const auto& [row, event] : *events) {
        // Skip restarts, because the reader detects them in the time stamps.
        if (event.source != QLatin1String(kRestartSource)) {
            const std::int64_t utcNs = start ? *start + std::llround(event.seconds * 1e9) : 0;
            notes.push_back({row, {utcNs, event.level, event.source, event.text}});
        }
    }
    return writeCsvNotes(choice.path, notes);
}

}  // namespace

Result<void> writeCsvNotes(const Text& path, const std::vector<RowNote>& notes) {
    std::string lines;
    for (const RowNote& note : notes) {
        lines +=
            isCsvNote(note.note.level, note.note.source) ? csvNoteLine(note.row, note.note) : std::string();
    }
    if (const Result<void> free = removeCsvNotes(path); !free) {
        return lines.empty() ? Result<void>() : free;
    }
    if (lines.empty()) {
        return {};
    }
    AtomicFile file(csvNotesPath(path));
    Result<void> done = file.open();
    done = done ? file.write(csvNotesHeader() + lines) : done;
    return done ? file.commit() : done;
}

Result<ExportReport> exportCsv(const Recording& recording, const ExportChoice& choice,
                               const CsvStyle& style) {
    if (std::string_view(",;\t").find(style.separator) == std::string_view::npos ||
        std::string_view(".,").find(style.decimal) == std::string_view::npos ||
        style.separator == style.decimal) {
        return Error{
            ErrorCode::InvalidArgument, QStringLiteral("export to %1").arg(choice.path),
            QStringLiteral("use , ; or a tab as separator and a point or a comma as decimal separator, "
                           "but not a comma for both")};
    }
    const auto columns = columnsWithTime(recording, choice.columns);
    if (!columns) {
        return columns.error();
    }
    const auto rows = chooseRows(recording, choice);
    if (!rows) {
        return rows.error();
    }
    AtomicFile file(choice.path);
    if (const Result<void> opened = file.open(); !opened) {
        return opened.error();
    }
    // If no column of the recording contains the times, a time column is added.
    const bool hasOwnTime = !recording.timeColumn();
    // Other programs write time stamps in other units, so the unit of a time is written unless the file is
    // recognized as that of a robot.
    const bool isRobotTable = std::any_of(columns->begin(), columns->end(), [&recording](std::size_t column) {
        return isOfRobot(recording.columns()[column]);
    });
    std::string heading = hasOwnTime ? style.unitsLine ? "time" : "time [s]" : "";
    std::string units = hasOwnTime ? "s" : "";
    for (const std::size_t column : columns.value()) {
        const RecordedColumn& described = recording.columns()[column];
        const bool needsUnit = !style.unitsLine && !isRobotTable && column == recording.timeColumn();
        heading += (heading.empty() ? "" : std::string(1, style.separator)) +
                   csvCell(needsUnit ? described.name + " [" + described.unit + ']' : described.name,
                           style.separator);
        // An empty cell would look like a missing number.
        const std::string unit = described.unit.empty() ? "-" : described.unit;
        units += (units.empty() ? "" : std::string(1, style.separator)) + csvCell(unit, style.separator);
    }
    ExportReport report;
    const auto write = [&](const char* text, std::size_t size) {
        report.bytes += static_cast<std::int64_t>(size);
        return file.write(std::string_view(text, size));
    };
    std::string head;
    if (style.head) {
        const auto first = recording.times({rows->first, 1});
        if (!first) {
            return first.error();
        }
        std::optional<std::int64_t> start = recording.startUtcNs();
        if (start && !first->empty()) {
            *start += std::llround(first->front() * 1e9);
        }
        std::vector<std::string> columnUnits(hasOwnTime ? 1 : 0, "s");
        for (const std::size_t column : columns.value()) {
            columnUnits.push_back(recording.columns()[column].unit);
        }
        head = csvHeadLines(recording.facts(), start, columnUnits, style.separator);
    }
    const std::string above = head + heading + '\n' + (style.unitsLine ? units + '\n' : std::string());
    if (const Result<void> written = write(above.data(), above.size()); !written) {
        return written.error();
    }
    const std::size_t count = columns.value().size();
    std::vector<std::uint8_t> whole;
    for (const std::size_t column : columns.value()) {
        whole.push_back(recording.columns()[column].whole ? 1 : 0);
    }
    const std::size_t longestRow = (count + 1) * (kMaxNumber + 1) + 1;
    const auto text = std::make_unique_for_overwrite<char[]>(longestRow * kRowsAtOnce);
    std::vector<const double*> values(count);
    for (std::uint64_t done = 0; done < rows.value().count; done += kRowsAtOnce) {
        if (choice.progress &&
            !choice.progress(static_cast<double>(done) / static_cast<double>(rows.value().count))) {
            return Error{ErrorCode::Cancelled, QStringLiteral("export to %1").arg(choice.path), {}};
        }
        const RowRange part{rows.value().first + done, std::min(kRowsAtOnce, rows.value().count - done)};
        const auto read = recording.read(columns.value(), part);
        const auto times =
            hasOwnTime ? recording.times(part) : Result<std::vector<double>>(std::vector<double>());
        if (!read || !times) {
            return read ? times.error() : read.error();
        }
        std::transform(read->begin(), read->end(), values.begin(),
                       [](const std::vector<double>& column) { return column.data(); });
        char* at = text.get();
        for (std::size_t row = 0; row < part.count; ++row) {
            if (hasOwnTime) {
                at = putNumber(at, (*times)[row], false, style.decimal);
                *at++ = style.separator;
            }
            for (std::size_t i = 0; i < count; ++i) {
                at = putNumber(at, values[i][row], whole[i] != 0, style.decimal);
                *at++ = style.separator;
            }
            at[-1] = '\n';
        }
        if (const Result<void> written = write(text.get(), static_cast<std::size_t>(at - text.get()));
            !written) {
            return written.error();
        }
        report.rows += part.count;
    }
    if (const Result<void> committed = file.commit(); !committed) {
        return committed.error();
    }
    if (const Result<void> noted = exportNotes(recording, choice, rows.value()); !noted) {
        return noted.error();
    }
    return report;
}

}  // namespace tiller::recording
