// SPDX-License-Identifier: MIT
#include "tests/benchmarks/backend/report.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

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

void Report::add(const QString& what, const realtime::Histogram& h, std::int64_t limitNs, bool required) {
    const auto ms = [](std::int64_t ns) { return static_cast<double>(ns) / 1e6; };
    add(what + QStringLiteral(": count"), static_cast<double>(h.count()), QString());
    add(what + QStringLiteral(": p50"), ms(h.percentileNs(50)), QStringLiteral("ms"));
    add(what + QStringLiteral(": p99.9"), ms(h.percentileNs(99.9)), QStringLiteral("ms"));
    add(what + QStringLiteral(": longest"), ms(h.maxNs()), QStringLiteral("ms"));
    add(what + QStringLiteral(": above %1 ms").arg(ms(limitNs)), static_cast<double>(h.countAbove(limitNs)),
        QString(), required ? std::optional(0.0) : std::nullopt);
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
                    .arg(row.what, -58)
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
