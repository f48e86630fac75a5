// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/problem_report.h"

#include <zlib.h>

#include <QDateTime>
#include <QDir>
#include <QGuiApplication>
#include <QRegularExpression>
#include <QScreen>
#include <QSysInfo>
#include <QThread>
#include <QtEndian>
#include <algorithm>

#include "robot/core/atomic_file.h"
#include "robot/core/robot_model.h"
#include "tiller_version.h"

namespace tiller::app {
namespace {

/// Returns the versions in English regardless of the user's language, for the support team.
QString versionsText(const SessionState& state) {
    QStringList lines{QStringLiteral("Tiller     %1").arg(QStringLiteral(TILLER_VERSION)),
                      QStringLiteral("Qt         %1, built with %2")
                          .arg(QString::fromLatin1(qVersion()), QStringLiteral(QT_VERSION_STR)),
                      QStringLiteral("System     %1, %2 %3, %4")
                          .arg(QSysInfo::prettyProductName(), QSysInfo::kernelType(),
                               QSysInfo::kernelVersion(), QSysInfo::currentCpuArchitecture()),
                      QStringLiteral("Display    %1").arg(QGuiApplication::platformName()),
                      QStringLiteral("Processors %1").arg(QThread::idealThreadCount())};
    const QList<QScreen*> screens = QGuiApplication::screens();
    for (const QScreen* screen : screens) {
        lines << QStringLiteral("Screen     %1 x %2, scale %3")
                     .arg(screen->size().width())
                     .arg(screen->size().height())
                     .arg(screen->devicePixelRatio());
    }
    if (state.link == LinkState::Live) {
        lines << QStringLiteral("Robot      %1%2, software %3.%4.%5")
                     .arg(QString::fromLatin1(robotModel(state.model).name),
                          state.simulated ? QStringLiteral(" (simulated)") : QString())
                     .arg(state.version.major)
                     .arg(state.version.minor)
                     .arg(state.version.bugfix);
    } else {
        lines << QStringLiteral("Robot      not connected");
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

/// Returns the data of the stop as CSV, for spreadsheets.
QByteArray stopTable(const StopRecord& stop) {
    QByteArray text = "time_s,force_N,tcp_speed_m_s";
    for (int joint = 1; joint <= 6; ++joint) {
        text += ",current_" + QByteArray::number(joint) + "_A,deviation_" + QByteArray::number(joint) + "_A";
    }
    text += '\n';
    for (const StopRecord::Point& point : stop.points) {
        text += QByteArray::number(point.time - stop.stoppedAt, 'f', 4) + ',' +
                QByteArray::number(point.force, 'f', 2) + ',' + QByteArray::number(point.speed, 'f', 5);
        for (Eigen::Index joint = 0; joint < 6; ++joint) {
            text += ',' + QByteArray::number(point.current[joint], 'f', 3) + ',' +
                    QByteArray::number(point.deviation[joint], 'f', 3);
        }
        text += '\n';
    }
    return text;
}

/// Returns a copy without names and addresses.
SettingsBundle withoutNames(const SettingsBundle& settings) {
    SettingsBundle kept{settings.writtenBy, {}};
    for (auto it = settings.values.constBegin(); it != settings.values.constEnd(); ++it) {
        const SettingsPart part = partOf(it.key());
        if (part != SettingsPart::Robots && part != SettingsPart::IoNames && part != SettingsPart::Other) {
            kept.values.insert(it.key(), it.value());
        }
    }
    return kept;
}

template <class Number>
void append(QByteArray& to, Number value) {
    const Number little = qToLittleEndian(value);
    to.append(reinterpret_cast<const char*>(&little), sizeof little);
}

/// Returns the header fields that the local header and the central directory have in common.
QByteArray zipEntry(const ReportPart& part, const QByteArray& packed, const QDateTime& when) {
    QByteArray entry;
    append<std::uint16_t>(entry, 20);       // version needed to extract
    append<std::uint16_t>(entry, 1 << 11);  // flag: the name is UTF-8
    append<std::uint16_t>(entry, 8);        // compression method: deflate
    const QTime time = when.time();
    const QDate date = when.date();
    append(entry, static_cast<std::uint16_t>(time.hour() << 11 | time.minute() << 5 | time.second() / 2));
    append(entry, static_cast<std::uint16_t>((date.year() - 1980) << 9 | date.month() << 5 | date.day()));
    append(entry,
           static_cast<std::uint32_t>(::crc32(0, reinterpret_cast<const Bytef*>(part.content.constData()),
                                              static_cast<uInt>(part.content.size()))));
    append(entry, static_cast<std::uint32_t>(packed.size()));
    append(entry, static_cast<std::uint32_t>(part.content.size()));
    append(entry, static_cast<std::uint16_t>(part.name.toUtf8().size()));
    append<std::uint16_t>(entry, 0);  // no extra field
    return entry;
}

/// Returns raw deflate data, without the zlib header.
QByteArray deflated(const QByteArray& content) {
    constexpr qsizetype kQtLength = 4;
    constexpr qsizetype kZlibHead = 2;
    constexpr qsizetype kZlibSum = 4;
    // qCompress() returns no data for empty input. Use an empty deflate block instead.
    return content.isEmpty() ? QByteArray("\x03\x00", 2)
                             : qCompress(content).mid(kQtLength + kZlibHead).chopped(kZlibSum);
}

}  // namespace

QString withoutNames(QString text, const QStringList& names) {
    QStringList sorted = names;
    // Replace the longest name first, because one name may be part of another.
    std::ranges::sort(sorted, [](const QString& a, const QString& b) { return a.size() > b.size(); });
    for (const QString& name : std::as_const(sorted)) {
        if (name.size() > 1) {
            text.replace(name, QStringLiteral("<name>"));
        }
    }
    static const QRegularExpression address(
        QStringLiteral(R"(\b(?!127\.)\d{1,3}\.\d{1,3}\.\d{1,3}\.\d{1,3}\b)"));
    static const QRegularExpression six(
        QStringLiteral(R"(\b(?:[0-9A-Fa-f]{1,4}:){3,7}:?[0-9A-Fa-f]{1,4}\b)"));
    text.replace(address, QStringLiteral("<address>"));
    text.replace(six, QStringLiteral("<address>"));
    text.replace(QDir::homePath(), QStringLiteral("<home>"));
    return text;
}

QVector<ReportPart> reportParts(const ReportSources& sources, bool names, const QString& words) {
    QVector<ReportPart> parts;
    const auto add = [&](const QString& name, const QString& text) {
        parts.append({name, (names ? text : withoutNames(text, sources.knownNames)).toUtf8()});
    };
    if (!words.trimmed().isEmpty()) {
        parts.append({QStringLiteral("what-happened.txt"), words.toUtf8()});
    }
    add(QStringLiteral("versions.txt"), versionsText(sources.state));
    add(QStringLiteral("log.txt"), sources.log);
    const SettingsBundle settings = names ? sources.settings : withoutNames(sources.settings);
    add(QStringLiteral("settings.json"), QString::fromUtf8(settingsToJson(settings)));
    if (sources.lastStop) {
        add(QStringLiteral("last-stop.txt"),
            sources.lastStop->reports.join(QLatin1Char('\n')) + QLatin1Char('\n'));
        parts.append({QStringLiteral("last-stop.csv"), stopTable(*sources.lastStop)});
    }
    if (!sources.crash.isEmpty()) {
        add(QStringLiteral("crash.txt"), QString::fromUtf8(sources.crash));
    }
    return parts;
}

QByteArray zipped(const QVector<ReportPart>& parts) {
    QByteArray archive;
    QByteArray directory;
    const QDateTime now = QDateTime::currentDateTime();
    for (const ReportPart& part : parts) {
        const QByteArray packed = deflated(part.content);
        const QByteArray entry = zipEntry(part, packed, now);
        const auto place = static_cast<std::uint32_t>(archive.size());
        archive += QByteArrayLiteral("PK\x03\x04") + entry + part.name.toUtf8() + packed;
        directory += QByteArrayLiteral("PK\x01\x02");
        append<std::uint16_t>(directory, 20);  // version that created the file
        directory += entry;
        directory += QByteArray(6, '\0');  // no comment, first disk, no attributes
        append<std::uint32_t>(directory, 0);
        append(directory, place);
        directory += part.name.toUtf8();
    }
    const auto place = static_cast<std::uint32_t>(archive.size());
    archive += directory + QByteArrayLiteral("PK\x05\x06") + QByteArray(4, '\0');
    append(archive, static_cast<std::uint16_t>(parts.size()));
    append(archive, static_cast<std::uint16_t>(parts.size()));
    append(archive, static_cast<std::uint32_t>(directory.size()));
    append(archive, place);
    append<std::uint16_t>(archive, 0);
    return archive;
}

Result<void> writeReport(const QString& path, const QVector<ReportPart>& parts) {
    return writeFileAtomically(path, zipped(parts));
}

}  // namespace tiller::app
