// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>

#include "tiller_version.h"

namespace tiller::app {
namespace {

constexpr int kRobotsRemembered = 8;
constexpr int kProjectsRemembered = 8;
constexpr qsizetype kMaxIoText = 100;
/// Other port offsets would lead to invalid port numbers.
constexpr int kLowestPortOffset = -29000;
constexpr int kHighestPortOffset = 35000;

/// Returns the settings key, in which an underscore replaces a slash of the robot name, because a slash would
/// create a nested group.
QString gripperKey(const QString& robot) {
    return QStringLiteral("grippers/") + QString(robot).replace(QLatin1Char('/'), QLatin1Char('_'));
}

QVector<RobotAddress> robotsIn(const SettingsView& settings) {
    QVector<RobotAddress> robots;
    const int count = std::min(settings.value("robots/size").toInt(), kRobotsRemembered);
    for (int i = 0; i < count; ++i) {
        const QString group = QStringLiteral("robots/%1/").arg(i + 1);
        const QString host = settings.value(group + "host").toString();
        const int offset = settings.value(group + "portOffset").toInt();
        if (!host.isEmpty() && offset >= kLowestPortOffset && offset <= kHighestPortOffset) {
            const QString name = settings.value(group + "name").toString();
            robots.append({name.isEmpty() ? host : name, host, offset, false});
        }
    }
    return robots;
}

void writeRobots(SettingsEdit& settings, const QVector<RobotAddress>& robots) {
    settings.remove("robots");
    settings.setValue("robots/size", static_cast<int>(robots.size()));
    for (int i = 0; i < robots.size(); ++i) {
        const QString group = QStringLiteral("robots/%1/").arg(i + 1);
        settings.setValue(group + "name", robots[i].name);
        settings.setValue(group + "host", robots[i].host);
        settings.setValue(group + "portOffset", robots[i].portOffset);
    }
}

QStringList projectsIn(const SettingsView& settings) {
    QStringList projects = settings.value("projects/recent").toStringList();
    // Also read the key of earlier versions.
    projects.append(settings.value("session/file").toString());
    projects.removeAll(QString());
    projects.removeDuplicates();
    return projects.mid(0, kProjectsRemembered);
}

TutorialProgress tutorialProgressIn(const SettingsView& settings) {
    return {settings.value("learned/dismissed").toBool(), settings.value("learned/firstSteps").toStringList(),
            settings.value("learned/practice").toStringList()};
}

/// Applies the changes from `before` to `after` to the list `there`.
QStringList merged(const QStringList& before, const QStringList& after, QStringList there) {
    for (const QString& word : before) {
        if (!after.contains(word)) {
            there.removeAll(word);
        }
    }
    for (const QString& word : after) {
        if (!before.contains(word) && !there.contains(word)) {
            there.append(word);
        }
    }
    return there;
}

SettingsMap ioNamesIn(const SettingsView& settings) {
    SettingsMap names;
    const QStringList terminals = settings.childKeys("io");
    for (const QString& terminal : terminals) {
        names[terminal] = settings.value("io/" + terminal).toString().left(kMaxIoText);
    }
    return names;
}

void writeParts(SettingsEdit& settings, const SettingsBundle& bundle, const QSet<SettingsPart>& parts) {
    const QStringList keys = settings.values().keys();
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

}  // namespace

Settings::Settings(QString file) : file_(std::move(file)) {}

Result<void> Settings::edit(const std::function<void(SettingsEdit&)>& change) {
    SettingsEdit settings(file_);
    change(settings);
    const Result<void> written = settings.commit();
    if (!written && !failed_ && writeFailed_) {
        writeFailed_(written.error());
    }
    failed_ = !written;
    return written;
}

QVector<RobotAddress> Settings::rememberedRobots() const {
    return robotsIn(SettingsView(file_));
}

RobotAddress Settings::robotAt(const QString& host) const {
    const QVector<RobotAddress> robots = rememberedRobots();
    const auto known = std::find_if(robots.cbegin(), robots.cend(),
                                    [&host](const RobotAddress& robot) { return robot.host == host; });
    return known == robots.cend() ? RobotAddress{host, host, 0, false} : *known;
}

void Settings::rememberRobot(const RobotAddress& robot) {
    (void)edit([&robot](SettingsEdit& settings) {
        QVector<RobotAddress> robots = robotsIn(settings);
        robots.removeIf([&robot](const RobotAddress& other) { return other.host == robot.host; });
        robots.prepend(robot);
        writeRobots(settings, robots.mid(0, kRobotsRemembered));
    });
}

void Settings::forgetRobot(const RobotAddress& robot) {
    (void)edit([&robot](SettingsEdit& settings) {
        QVector<RobotAddress> robots = robotsIn(settings);
        robots.removeIf([&robot](const RobotAddress& other) { return other.host == robot.host; });
        writeRobots(settings, robots);
    });
}

QString Settings::theme() const {
    const QString theme = SettingsView(file_).value("look/theme").toString();
    return theme == "light" || theme == "dark" ? theme : QString();
}

void Settings::setTheme(const QString& theme) {
    (void)edit([&theme](SettingsEdit& settings) { settings.setValue("look/theme", theme); });
}

QByteArray Settings::windowGeometry() const {
    return SettingsView(file_).value("window/geometry").toByteArray();
}

void Settings::setWindowGeometry(const QByteArray& geometry) {
    (void)edit([&geometry](SettingsEdit& settings) { settings.setValue("window/geometry", geometry); });
}

QMap<QString, QString> Settings::ioNames() const {
    knownIoNames_ = ioNamesIn(SettingsView(file_));
    QMap<QString, QString> names;
    for (auto it = knownIoNames_->constBegin(); it != knownIoNames_->constEnd(); ++it) {
        names[it.key()] = it->toString();
    }
    return names;
}

void Settings::setIoNames(const QMap<QString, QString>& names) {
    SettingsMap after;
    for (auto it = names.constBegin(); it != names.constEnd(); ++it) {
        after.insert(it.key(), it.value());
    }
    const Result<void> written = edit([this, &after](SettingsEdit& settings) {
        settings.merge("io", knownIoNames_ ? *knownIoNames_ : ioNamesIn(settings), after);
    });
    if (written) {
        knownIoNames_ = after;
    }
}

QString Settings::gripper(const QString& robot) const {
    return SettingsView(file_).value(gripperKey(robot)).toString();
}

void Settings::setGripper(const QString& robot, const QString& choice) {
    (void)edit([&](SettingsEdit& settings) {
        if (choice.isEmpty()) {
            settings.remove(gripperKey(robot));
        } else {
            settings.setValue(gripperKey(robot), choice);
        }
    });
}

QStringList Settings::recentProjects() const {
    return projectsIn(SettingsView(file_));
}

void Settings::rememberProject(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    (void)edit([&absolute](SettingsEdit& settings) {
        QStringList projects = projectsIn(settings);
        projects.removeAll(absolute);
        projects.prepend(absolute);
        settings.setValue("projects/recent", projects.mid(0, kProjectsRemembered));
    });
}

QByteArray Settings::plots() const {
    return SettingsView(file_).value("plots/arrangement").toString().toUtf8();
}

std::size_t Settings::plotBudget() const {
    constexpr int kMaxMegabytes = 65536;
    return static_cast<std::size_t>(
               std::clamp(SettingsView(file_).value("plots/budget").toInt(), 0, kMaxMegabytes))
           << 20;
}

void Settings::setPlots(const QByteArray& arrangement, std::size_t budget) {
    (void)edit([&](SettingsEdit& settings) {
        settings.setValue("plots/arrangement", QString::fromUtf8(arrangement));
        settings.setValue("plots/budget", static_cast<int>(budget >> 20));
    });
}

TutorialProgress Settings::learned() const {
    knownTutorial_ = tutorialProgressIn(SettingsView(file_));
    return *knownTutorial_;
}

void Settings::setTutorialProgress(const TutorialProgress& learned) {
    const Result<void> written = edit([&](SettingsEdit& settings) {
        const TutorialProgress there = tutorialProgressIn(settings);
        const TutorialProgress before = knownTutorial_ ? *knownTutorial_ : there;
        if (learned.dismissed != before.dismissed || !settings.contains("learned/dismissed")) {
            settings.setValue("learned/dismissed", learned.dismissed);
        }
        settings.setValue("learned/firstSteps",
                          merged(before.firstSteps, learned.firstSteps, there.firstSteps));
        settings.setValue("learned/practice", merged(before.practice, learned.practice, there.practice));
    });
    if (written) {
        knownTutorial_ = learned;
    }
}

Preferences Settings::preferences() const {
    const Preferences preferences = readPreferences(SettingsView(file_));
    knownPreferences_ = preferenceValues(preferences);
    return preferences;
}

void Settings::setPreferences(const Preferences& preferences) {
    const SettingsMap after = preferenceValues(preferences);
    const Result<void> written = edit([&](SettingsEdit& settings) {
        settings.merge(
            {}, knownPreferences_ ? *knownPreferences_ : preferenceValues(readPreferences(settings)), after);
    });
    if (written) {
        knownPreferences_ = after;
    }
}

QVector<SavedPerspective> Settings::perspectives() const {
    knownPerspectives_ = readPerspectives(SettingsView(file_));
    return *knownPerspectives_;
}

QVector<SavedPerspective> Settings::setPerspectives(const QVector<SavedPerspective>& all) {
    QVector<SavedPerspective> merged = all;
    const Result<void> written = edit([&](SettingsEdit& settings) {
        const QVector<SavedPerspective> there = readPerspectives(settings);
        merged = mergePerspectives(knownPerspectives_ ? *knownPerspectives_ : there, all, there);
        writePerspectives(settings, merged);
    });
    if (!written) {
        return all;
    }
    knownPerspectives_ = merged;
    return merged;
}

void Settings::setArrangement(const LastArrangement& arrangement) {
    (void)edit([&arrangement](SettingsEdit& settings) { writeArrangement(settings, arrangement); });
}

SettingsBundle Settings::bundle() const {
    SettingsBundle bundle;
    bundle.writtenBy = QStringLiteral(TILLER_VERSION);
    const SettingsView settings(file_);
    for (auto it = settings.values().constBegin(); it != settings.values().constEnd(); ++it) {
        if (travels(it.key())) {
            bundle.values.insert(it.key(), it.value());
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

Result<QString> Settings::replace(const SettingsBundle& bundle, const QSet<SettingsPart>& parts) {
    const QString backup = backupPath();
    if (const Result<void> kept = writeSettingsFile(backup, this->bundle()); !kept) {
        return kept.error();
    }
    const Result<void> written = edit([&](SettingsEdit& settings) { writeParts(settings, bundle, parts); });
    return written ? Result<QString>(backup) : Result<QString>(written.error());
}

}  // namespace tiller::app
