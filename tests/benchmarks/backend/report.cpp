// SPDX-License-Identifier: MIT
#include "tests/benchmarks/backend/report.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <utility>

namespace tiller::benchmark {

void Report::begin(const QString& section) {
    section_ = section;
}

void Report::add(const QString& what, double value, const QString& unit, std::optional<double> limit) {
    rows_.push_back({section_, what, value, unit, limit, {}});
}

void Report::cannot(const QString& what, const QString& why) {
    rows_.push_back({section_, what, 0, {}, {}, why});
}

void Spans::add(std::int64_t fromNs, std::int64_t toNs) {
    if (spans_.size() == spans_.capacity()) {
        overflowed_ = true;
        return;
    }
    spans_.push_back({fromNs, toNs});
}

Durations::Durations(std::vector<std::int64_t> ns) : ns_(std::move(ns)) {
    std::sort(ns_.begin(), ns_.end());
}

std::int64_t Durations::percentileNs(double percent) const {
    if (ns_.empty()) {
        return 0;
    }
    const double rank = std::ceil(percent / 100 * static_cast<double>(ns_.size()));
    return ns_[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

std::size_t Durations::countAbove(std::int64_t ns) const {
    return static_cast<std::size_t>(ns_.end() - std::upper_bound(ns_.begin(), ns_.end(), ns));
}

Durations Spans::all() const {
    std::vector<std::int64_t> all;
    for (const Span& span : spans_) {
        all.push_back(span.toNs - span.fromNs);
    }
    return Durations(std::move(all));
}

Durations Spans::quieterHalf() const {
    constexpr std::int64_t kPartNs = 500'000'000;
    std::vector<std::vector<std::int64_t>> parts;
    std::int64_t partFrom = 0;
    for (const Span& span : spans_) {
        if (parts.empty() || span.fromNs - partFrom >= kPartNs) {
            parts.emplace_back();
            partFrom = span.fromNs;
        }
        parts.back().push_back(span.toNs - span.fromNs);
    }
    const auto longest = [](const auto& part) { return *std::max_element(part.begin(), part.end()); };
    std::sort(parts.begin(), parts.end(),
              [&](const auto& a, const auto& b) { return longest(a) < longest(b); });
    std::vector<std::int64_t> quieter;
    for (std::size_t i = 0; i < (parts.size() + 1) / 2; ++i) {
        quieter.insert(quieter.end(), parts[i].begin(), parts[i].end());
    }
    return Durations(std::move(quieter));
}

Durations Spans::whileThere(const MachineWatch& watch) const {
    std::vector<std::int64_t> there;
    // The cause of a delay may have occurred shortly before the span.
    constexpr std::int64_t kMarginNs = 2'000'000;
    for (const Span& span : spans_) {
        if (!watch.wasAway(span.fromNs - kMarginNs, span.toNs)) {
            there.push_back(span.toNs - span.fromNs);
        }
    }
    return Durations(std::move(there));
}

void Report::add(const QString& what, const Spans& spans, const MachineWatch& watch, std::int64_t limitNs,
                 bool required) {
    const auto ms = [](std::int64_t ns) { return static_cast<double>(ns) / 1e6; };
    const auto rows = [&](const QString& which, const Durations& h, std::optional<double> limit) {
        add(which + QStringLiteral(": count"), static_cast<double>(h.count()), QString());
        add(which + QStringLiteral(": p50"), ms(h.percentileNs(50)), QStringLiteral("ms"));
        add(which + QStringLiteral(": p99.9"), ms(h.percentileNs(99.9)), QStringLiteral("ms"));
        add(which + QStringLiteral(": longest"), ms(h.maxNs()), QStringLiteral("ms"));
        add(which + QStringLiteral(": above %1 ms").arg(ms(limitNs)),
            static_cast<double>(h.countAbove(limitNs)), QString(), limit);
    };
    rows(what, spans.all(), {});
    if (!watch.isWatching() || spans.overflowed()) {
        cannot(what + QStringLiteral(", machine there"), watch.isWatching()
                                                             ? QStringLiteral("more than were expected")
                                                             : QStringLiteral("the watch has no priority"));
        return;
    }
    rows(what + QStringLiteral(", machine there"), spans.whileThere(watch),
         required ? std::optional(0.0) : std::nullopt);
}

bool Report::passed() const {
    return std::all_of(rows_.begin(), rows_.end(), [](const Row& row) { return row.passed(); });
}

QString Report::table() const {
    QString text;
    QString section;
    for (const Row& row : rows_) {
        if (row.section != section) {
            section = row.section;
            text += QStringLiteral("\n%1\n").arg(section);
        }
        const QString verdict = !row.remark.isEmpty() ? QStringLiteral("not measured: ") + row.remark
                                : !row.limit          ? QString()
                                : row.passed()        ? QStringLiteral("pass (limit %1)").arg(*row.limit)
                                                      : QStringLiteral("FAIL (limit %1)").arg(*row.limit);
        const QString value = row.remark.isEmpty() ? QString::number(row.value, 'g', 6) : QString();
        text += QStringLiteral("  %1 %2 %3  %4\n")
                    .arg(row.what, -64)
                    .arg(value, 10)
                    .arg(row.unit, -4)
                    .arg(verdict);
    }
    return text;
}

QByteArray Report::json() const {
    QJsonArray rows;
    for (const Row& row : rows_) {
        QJsonObject object{{"section", row.section}, {"what", row.what}, {"passed", row.passed()}};
        if (row.remark.isEmpty()) {
            object["value"] = row.value;
            object["unit"] = row.unit;
        } else {
            object["remark"] = row.remark;
        }
        if (row.limit) {
            object["limit"] = *row.limit;
        }
        rows.append(object);
    }
    return QJsonDocument(QJsonObject{{"passed", passed()}, {"rows", rows}}).toJson(QJsonDocument::Compact);
}

}  // namespace tiller::benchmark
