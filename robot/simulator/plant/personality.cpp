// SPDX-License-Identifier: MIT
#include "robot/simulator/plant/personality.h"

#include <QDate>
#include <QStringList>
#include <cstdio>

namespace tiller::simulator {

namespace {

struct Release {
    SoftwareVersion version;
    int day, month, year;
};

// The entries are sorted by version. The build numbers and dates of 3.15.8 and 5.12.0 are from the dashboard
// guide. No public source lists the others, so they are plausible values. Clients only compare the numbers.
constexpr Release kReleases[] = {
    {{3, 15, 8, 106339}, 20, 6, 2022},  {{5, 11, 6, 1080301}, 10, 12, 2021},
    {{5, 12, 0, 1101319}, 22, 3, 2022}, {{5, 22, 1, 1214193}, 12, 3, 2025},
    {{5, 25, 0, 1254012}, 18, 2, 2026}, {{10, 12, 0, 1260431}, 10, 3, 2026},
};

/// Returns the newest release of the series that is not newer than `software`, or the first of the series.
const Release* closest(const SoftwareVersion& software) {
    const Release* best = nullptr;
    for (const Release& release : kReleases) {
        if (release.version.major == software.major &&
            (best == nullptr || release.version.minor <= software.minor)) {
            best = &release;
        }
    }
    return best;
}

QDate dayOf(const SoftwareVersion& software) {
    const Release* release = closest(software);
    return release == nullptr ? QDate(2025, 1, 1) : QDate(release->year, release->month, release->day);
}

Error wrongOption(const QString& what) {
    return {ErrorCode::InvalidArgument, what, {}};
}

/// The first release that supports a model. Source: the vendor's simulator images.
SoftwareVersion firstSoftware(RobotModelId model, bool polyScopeX) {
    struct Since {
        RobotModelId model;
        SoftwareVersion five, x;
    };
    static constexpr Since kSince[] = {
        {RobotModelId::UR7e, {5, 22, 0, 0}, {10, 9, 0, 0}},
        {RobotModelId::UR12e, {5, 22, 0, 0}, {10, 9, 0, 0}},
        {RobotModelId::UR18, {5, 23, 0, 0}, {10, 11, 0, 0}},
        {RobotModelId::UR8Long, {5, 23, 0, 0}, {10, 11, 0, 0}},
        {RobotModelId::UR20, {5, 14, 0, 0}, {10, 7, 0, 0}},
        {RobotModelId::UR30, {5, 15, 0, 0}, {10, 7, 0, 0}},
        {RobotModelId::UR15, {5, 22, 0, 0}, {10, 8, 0, 0}},
    };
    for (const Since& since : kSince) {
        if (since.model == model) {
            return polyScopeX ? since.x : since.five;
        }
    }
    return polyScopeX ? SoftwareVersion{10, 7, 0, 0} : SoftwareVersion{5, 0, 0, 0};
}

}  // namespace

Result<SoftwareVersion> parseSoftware(const QString& text) {
    const QStringList parts = text.split('.');
    std::uint32_t numbers[4] = {0, 0, 0, 0};
    const Error notOne = wrongOption(
        QStringLiteral(
            "the software version must be of series 3, 5 or 10, such as 3.15, 5.22 or 10.12, not '%1'")
            .arg(text));
    if (parts.size() < 2 || parts.size() > 4) {
        return notOne;
    }
    for (qsizetype i = 0; i < parts.size(); ++i) {
        bool ok = false;
        numbers[i] = parts[i].toUInt(&ok);
        // The version message has only one byte each for the major and minor version.
        if (!ok || (i < 2 && numbers[i] > 255)) {
            return notOne;
        }
    }
    SoftwareVersion version{numbers[0], numbers[1], numbers[2], numbers[3]};
    if (version.major != 3 && version.major != 5 && version.major != 10) {
        return notOne;
    }
    const Release* known = closest(version);
    const bool same = known != nullptr && known->version.minor == version.minor;
    if (same && parts.size() == 2) {
        version = known->version;
    } else if (same && parts.size() == 3 && known->version.bugfix == version.bugfix) {
        version.build = known->version.build;
    }
    return version;
}

SoftwareVersion defaultSoftware(RobotModelId model) {
    if (robotModel(model).isCb3()) {
        return {3, 15, 8, 106339};
    }
    const SoftwareVersion usual{5, 22, 1, 1214193};
    return firstSoftware(model, false) <= usual ? usual : SoftwareVersion{5, 25, 0, 1254012};
}

Result<void> checkSoftware(RobotModelId id, const SoftwareVersion& software) {
    const RobotModel& model = robotModel(id);
    const QString name = QString::fromLatin1(model.name);
    const QString version = QString::fromStdString(versionText(software));
    if (software.isCb3() != model.isCb3()) {
        return wrongOption(QStringLiteral("a %1 does not run software %2: CB3 models run series 3, and all "
                                          "other models run series 5 and 10")
                               .arg(name, version));
    }
    const SoftwareVersion first = firstSoftware(id, software.isPolyScopeX());
    if (!model.isCb3() && software < first) {
        return wrongOption(QStringLiteral("a %1 does not run software %2: use version %3.%4 or later")
                               .arg(name, version)
                               .arg(first.major)
                               .arg(first.minor));
    }
    return {};
}

std::string versionText(const SoftwareVersion& v) {
    return std::to_string(v.major) + '.' + std::to_string(v.minor) + '.' + std::to_string(v.bugfix) + '.' +
           std::to_string(v.build);
}

std::string releaseDate(const SoftwareVersion& software) {
    static constexpr const char* kMonths[] = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                              "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
    const QDate day = dayOf(software);
    char text[32];
    std::snprintf(text, sizeof text, "%s %02d %d", kMonths[day.month() - 1], day.day(), day.year());
    return text;
}

std::string buildDate(const SoftwareVersion& software) {
    const QDate day = dayOf(software);
    char text[48];
    std::snprintf(text, sizeof text, "%02d-%02d-%d, 00:25:33", day.day(), day.month(), day.year());
    return text;
}

QString serialNumber(RobotModelId model, const SoftwareVersion& software) {
    // Year, series, model and robot number.
    return QStringLiteral("2022%1%2%3")
        .arg(software.isCb3() ? 3 : 5)
        .arg(static_cast<int>(model), 2, 10, QLatin1Char('0'))
        .arg(2022);
}

}  // namespace tiller::simulator
