// SPDX-License-Identifier: MIT
#include "robot/recording/csv_reader.h"

#include <QFile>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "robot/core/file_reading.h"

namespace tiller::recording {

namespace {

std::string_view trimmed(std::string_view cell) {
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!cell.empty() && blank(cell.front())) {
        cell.remove_prefix(1);
    }
    while (!cell.empty() && blank(cell.back())) {
        cell.remove_suffix(1);
    }
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
        cell = cell.substr(1, cell.size() - 2);
    }
    return cell;
}

/// Calls sink(cell) for every cell of a line, including an empty last cell.
template <class Sink>
void forEachCell(std::string_view line, Sink sink) {
    for (;;) {
        const std::size_t comma = line.find(',');
        sink(trimmed(line.substr(0, comma)));
        if (comma == std::string_view::npos) {
            return;
        }
        line.remove_prefix(comma + 1);
    }
}

bool parseNumber(std::string_view cell, double& value) {
    if (cell.empty()) {
        value = std::numeric_limits<double>::quiet_NaN();
        return true;
    }
    if (cell.front() == '+') {
        cell.remove_prefix(1);
    }
    const auto [end, failure] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    return failure == std::errc() && end == cell.data() + cell.size();
}

QString shown(std::string_view cell) {
    constexpr std::size_t kLongest = 40;
    return QString::fromUtf8(cell.data(), static_cast<qsizetype>(std::min(cell.size(), kLongest)));
}

}  // namespace

std::optional<std::size_t> CsvTable::indexOf(std::string_view column) const {
    const auto found = std::find(columns.begin(), columns.end(), column);
    return found == columns.end() ? std::nullopt
                                  : std::optional(static_cast<std::size_t>(found - columns.begin()));
}

const std::vector<double>* CsvTable::column(std::string_view name) const {
    const auto index = indexOf(name);
    return index ? &values[*index] : nullptr;
}

Result<CsvTable> readCsv(const Text& path) {
    QFile file;
    if (const Result<void> opened = openForReading(file, path); !opened) {
        return opened.error();
    }
    const QByteArray content = file.readAll();
    if (file.error() != QFileDevice::NoError) {
        return Error{ErrorCode::FileNotReadable, path, file.errorString()};
    }
    std::string_view rest(content.constData(), static_cast<std::size_t>(content.size()));
    const auto corrupt = [&](std::size_t line, const QString& what) {
        return Error{
            ErrorCode::FileCorrupt, QStringLiteral("%1, line %2: %3").arg(path).arg(line).arg(what), {}};
    };
    CsvTable table;
    for (std::size_t number = 1; !rest.empty(); ++number) {
        const std::size_t end = rest.find('\n');
        if (end == std::string_view::npos) {
            // Even if the line seems complete, its last number may be truncated.
            table.truncated = true;
            break;
        }
        std::string_view line = rest.substr(0, end);
        if (!line.empty() && line.back() == '\r') {
            line.remove_suffix(1);
        }
        rest.remove_prefix(end + 1);
        if (table.columns.empty() && line.starts_with('#')) {
            continue;  // metadata
        }
        if (table.columns.empty()) {
            forEachCell(line, [&](std::string_view cell) { table.columns.emplace_back(cell); });
            table.values.resize(table.columns.size());
            continue;
        }
        if (line.empty()) {
            continue;
        }
        std::size_t cells = 0;
        std::optional<Error> failure;
        forEachCell(line, [&](std::string_view cell) {
            double value = 0;
            if (!failure && !parseNumber(cell, value)) {
                failure = corrupt(number, QStringLiteral("\"%1\" is not a number").arg(shown(cell)));
            }
            if (!failure && cells < table.values.size()) {
                table.values[cells].push_back(value);
            }
            ++cells;
        });
        if (!failure && cells != table.columns.size()) {
            failure = corrupt(number, QStringLiteral("the row has %1 cells, the header has %2")
                                          .arg(cells)
                                          .arg(table.columns.size()));
        }
        if (failure) {
            return *failure;
        }
    }
    if (table.columns.empty() || (table.columns.size() == 1 && table.columns.front().empty())) {
        return corrupt(1, QStringLiteral("the file has no header"));
    }
    return table;
}

}  // namespace tiller::recording
