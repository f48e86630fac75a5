// SPDX-License-Identifier: MIT
#include "robot/recording/detail/csv_head.h"

#include <QDateTime>
#include <algorithm>

#include "robot/core/clock.h"
#include "robot/recording/export.h"

namespace tiller::recording {

namespace {

constexpr int kFractionDigits = 9;
constexpr std::string_view kStart = "start";
constexpr std::string_view kUnits = "units";

void addLine(std::string& out, std::string_view name, std::string_view value) {
    std::string text(value);
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    out.append("# ").append(name).append(": ").append(text) += '\n';
}

std::string startText(std::int64_t utcNs) {
    const std::int64_t seconds = utcNs / kNsPerSecond - (utcNs % kNsPerSecond < 0 ? 1 : 0);
    const QString date =
        QDateTime::fromSecsSinceEpoch(seconds, Qt::UTC).toString(QStringLiteral("yyyy-MM-ddTHH:mm:ss"));
    return QStringLiteral("%1.%2Z")
        .arg(date)
        .arg(utcNs - seconds * kNsPerSecond, kFractionDigits, 10, QLatin1Char('0'))
        .toStdString();
}

std::optional<std::int64_t> startOf(std::string_view text) {
    constexpr qsizetype kDateLength = 19;
    const QString whole = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
    if (!whole.endsWith(QLatin1Char('Z')) || whole.size() < kDateLength + 1) {
        return std::nullopt;
    }
    QDateTime date = QDateTime::fromString(whole.left(kDateLength), Qt::ISODate);
    date.setTimeSpec(Qt::UTC);
    QString fraction = whole.mid(kDateLength + 1).chopped(whole.size() > kDateLength + 1 ? 1 : 0);
    fraction = fraction.left(kFractionDigits).leftJustified(kFractionDigits, QLatin1Char('0'));
    bool isNumber = false;
    const std::int64_t rest = fraction.toLongLong(&isNumber);
    const bool isFractional = whole[kDateLength] == QLatin1Char('.') || whole.size() == kDateLength + 1;
    constexpr std::int64_t kMaxSeconds = 9'000'000'000;
    if (!date.isValid() || !isNumber || rest < 0 || !isFractional ||
        std::abs(date.toSecsSinceEpoch()) > kMaxSeconds) {
        return std::nullopt;
    }
    return date.toSecsSinceEpoch() * kNsPerSecond + rest;
}

}  // namespace

std::string csvHeadLines(const Metadata& facts, std::optional<std::int64_t> startUtcNs,
                         std::span<const std::string> units, char separator) {
    std::string out;
    if (startUtcNs) {
        addLine(out, kStart, startText(*startUtcNs));
    }
    for (const auto& [name, value] : facts) {
        addLine(out, name, value);
    }
    std::string cells;
    for (const std::string& unit : units) {
        // An empty cell would look like a missing unit.
        cells +=
            (cells.empty() ? "" : std::string(1, separator)) + csvCell(unit.empty() ? "-" : unit, separator);
    }
    if (!cells.empty()) {
        addLine(out, kUnits, cells);
    }
    return out;
}

void takeCsvHeadLine(std::string_view line, CsvHead& head) {
    constexpr std::size_t kMaxFacts = 1000;
    const std::size_t colon = line.find(": ");
    if (!line.starts_with("# ") || colon == std::string_view::npos || head.facts.size() >= kMaxFacts) {
        return;
    }
    const std::string_view name = line.substr(2, colon - 2);
    const std::string_view value = line.substr(colon + 2);
    const auto start = name == kStart ? startOf(value) : std::nullopt;
    if (start) {
        head.startUtcNs = start;
    } else if (name == kUnits) {
        head.units = value;
    } else if (isMetadataName(name)) {
        head.facts.emplace(name, value);
    }
}

}  // namespace tiller::recording
