// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>
#include <algorithm>

#include "tiller_version.h"

namespace tiller::app {
namespace {

constexpr int kRobotsRemembered = 8;
constexpr int kProjectsRemembered = 8;
constexpr qsizetype kLongestIoText = 100;
/// Beyond these one of the robot's ports would be none.
constexpr int kLowestPortOffset = -29000;
constexpr int kHighestPortOffset = 35000;

/// A slash would begin a group within the group.
QString gripperKey(const QString& robot) {
    return QStringLiteral("grippers/") + QString(robot).replace(QLatin1Char('/'), QLatin1Char('_'));
}

}  // namespace

QSettings openSettings(const QString& file) {
    return file.isEmpty() ? QSettings(QStringLiteral("Tiller"), QStringLiteral("Tiller"))
                          : QSettings(file, QSettings::IniFormat);
}

Settings::Settings(QString file) : file_(std::move(file)) {}

QVector<RobotAddress> Settings::rememberedRobots() const {
    QVector<RobotAddress> robots;
    QSettings settings = openSettings(file_);
    const int count = std::min(settings.beginReadArray("robots"), kRobotsRemembered);
    for (int i = 0; i < count; ++i) {
        settings.setArrayIndex(i);
        const QString host = settings.value("host").toString();
        const int offset = settings.value("portOffset").toInt();
        if (!host.isEmpty() && offset >= kLowestPortOffset && offset <= kHighestPortOffset) {
            const QString name = settings.value("name").toString();
            robots.append({name.isEmpty() ? host : name, host, offset, false});
        }
    }
    return robots;
}

void Settings::rememberRobot(const RobotAddress& robot) {
    QVector<RobotAddress> robots = rememberedRobots();
    robots.removeIf([&robot](const RobotAddress& other) { return other.host == robot.host; });
    robots.prepend(robot);
    writeRobots(robots.mid(0, kRobotsRemembered));
}

void Settings::forgetRobot(const RobotAddress& robot) {
    QVector<RobotAddress> robots = rememberedRobots();
    robots.removeIf([&robot](const RobotAddress& other) { return other.host == robot.host; });
    writeRobots(robots);
}

void Settings::writeRobots(const QVector<RobotAddress>& robots) {
    QSettings settings = openSettings(file_);
    settings.remove("robots");
    settings.beginWriteArray("robots", static_cast<int>(robots.size()));
    for (int i = 0; i < robots.size(); ++i) {
        settings.setArrayIndex(i);
        settings.setValue("name", robots[i].name);
        settings.setValue("host", robots[i].host);
        settings.setValue("portOffset", robots[i].portOffset);
    }
    settings.endArray();
}

QString Settings::theme() const {
    const QString theme = openSettings(file_).value("look/theme").toString();
    return theme == "light" || theme == "dark" ? theme : QString();
}

void Settings::setTheme(const QString& theme) {
    openSettings(file_).setValue("look/theme", theme);
}

QByteArray Settings::windowGeometry() const {
    return openSettings(file_).value("window/geometry").toByteArray();
}

void Settings::setWindowGeometry(const QByteArray& geometry) {
    openSettings(file_).setValue("window/geometry", geometry);
}

QMap<QString, QString> Settings::ioNames() const {
    QMap<QString, QString> names;
    QSettings settings = openSettings(file_);
    settings.beginGroup("io");
    const QStringList terminals = settings.childKeys();
    for (const QString& terminal : terminals) {
        names[terminal] = settings.value(terminal).toString().left(kLongestIoText);
    }
    return names;
}

void Settings::setIoNames(const QMap<QString, QString>& names) {
    QSettings settings = openSettings(file_);
    settings.remove("io");
    settings.beginGroup("io");
    for (auto it = names.constBegin(); it != names.constEnd(); ++it) {
        settings.setValue(it.key(), it.value());
    }
}

QString Settings::gripper(const QString& robot) const {
    return openSettings(file_).value(gripperKey(robot)).toString();
}

void Settings::setGripper(const QString& robot, const QString& choice) {
    QSettings settings = openSettings(file_);
    if (choice.isEmpty()) {
        settings.remove(gripperKey(robot));
    } else {
        settings.setValue(gripperKey(robot), choice);
    }
}

QStringList Settings::recentProjects() const {
    const QSettings settings = openSettings(file_);
    QStringList projects = settings.value("projects/recent").toStringList();
    // As earlier versions wrote it.
    projects.append(settings.value("session/file").toString());
    projects.removeAll(QString());
    projects.removeDuplicates();
    return projects.mid(0, kProjectsRemembered);
}

void Settings::rememberProject(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    QStringList projects = recentProjects();
    projects.removeAll(absolute);
    projects.prepend(absolute);
    openSettings(file_).setValue("projects/recent", projects.mid(0, kProjectsRemembered));
}

QByteArray Settings::plots() const {
    return openSettings(file_).value("plots/arrangement").toString().toUtf8();
}

std::size_t Settings::plotBudget() const {
    constexpr int kMostMegabytes = 65536;
    return static_cast<std::size_t>(
               std::clamp(openSettings(file_).value("plots/budget").toInt(), 0, kMostMegabytes))
           << 20;
}

void Settings::setPlots(const QByteArray& arrangement, std::size_t budget) {
    QSettings settings = openSettings(file_);
    settings.setValue("plots/arrangement", QString::fromUtf8(arrangement));
    settings.setValue("plots/budget", static_cast<int>(budget >> 20));
}

Learned Settings::learned() const {
    const QSettings settings = openSettings(file_);
    return {settings.value("learned/dismissed").toBool(), settings.value("learned/firstSteps").toStringList(),
            settings.value("learned/practice").toStringList()};
}

void Settings::setLearned(const Learned& learned) {
    QSettings settings = openSettings(file_);
    settings.setValue("learned/dismissed", learned.dismissed);
    settings.setValue("learned/firstSteps", learned.firstSteps);
    settings.setValue("learned/practice", learned.practice);
}

SettingsBundle Settings::bundle() const {
    SettingsBundle bundle;
    bundle.writtenBy = QStringLiteral(TILLER_VERSION);
    QSettings settings = openSettings(file_);
    settings.setFallbacksEnabled(false);  // ours, not those of the system
    const QStringList keys = settings.allKeys();
    for (const QString& key : keys) {
        if (travels(key)) {
            bundle.values.insert(key, settings.value(key));
        }
    }
    return bundle;
}

QString Settings::backupPath() const {
    const QString folder = file_.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)
                                           : QFileInfo(file_).absolutePath();
    QDir().mkpath(folder);
    const QString stamp = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HH-mm-ss-zzz"));
    return QDir(folder).filePath(QStringLiteral("settings-before-import_%1.json").arg(stamp));
}

void Settings::writeParts(const SettingsBundle& bundle, const QSet<SettingsPart>& parts) {
    QSettings settings = openSettings(file_);
    settings.setFallbacksEnabled(false);
    const QStringList keys = settings.allKeys();
    for (const QString& key : keys) {
        if (travels(key) && parts.contains(partOf(key))) {
            settings.remove(key);
        }
    }
    for (auto it = bundle.values.constBegin(); it != bundle.values.constEnd(); ++it) {
        if (travels(it.key()) && parts.contains(partOf(it.key()))) {
            settings.setValue(it.key(), it.value());
        }
    }
}

Result<QString> Settings::replace(const SettingsBundle& bundle, const QSet<SettingsPart>& parts) {
    const SettingsBundle before = this->bundle();
    const QString backup = backupPath();
    if (const Result<void> kept = writeSettingsFile(backup, before); !kept) {
        return kept.error();
    }
    writeParts(bundle, parts);
    QSettings settings = openSettings(file_);
    settings.sync();
    if (settings.status() != QSettings::NoError) {
        writeParts(before, parts);
        return Error{ErrorCode::FileNotWritable,
                     QCoreApplication::translate("SettingsFile", "write %1").arg(settings.fileName()),
                     {}};
    }
    return backup;
}

}  // namespace tiller::app
