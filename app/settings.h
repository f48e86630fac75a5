// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Values that are saved between two starts. The speed is not saved, so every start begins at low speed.

#include <QByteArray>
#include <QMap>
#include <QString>
#include <QStringList>
#include <QVector>
#include <functional>
#include <optional>

#include "app/perspective_store.h"
#include "app/preferences.h"
#include "app/settings_file.h"
#include "app/settings_store.h"
#include "robot/station/link/robot_session.h"

namespace tiller::app {

/// Progress of the tutorial, as names of steps and tasks.
struct TutorialProgress {
    bool dismissed = false;  ///< true if the user closed the checklist of the first steps
    QStringList firstSteps;
    QStringList practice;
};

class Settings {
public:
    /// file  the settings file; empty: the default location
    explicit Settings(QString file = {});

    /// Sets a function to call after a failed write. After that, it is not called again until a write has
    /// succeeded.
    void setWriteFailed(std::function<void(const Error&)> tell) { writeFailed_ = std::move(tell); }

    /// Remembered robots, newest first, without the simulated robot.
    QVector<RobotAddress> rememberedRobots() const;
    /// The remembered robot with this address, or a robot that is named after its address.
    RobotAddress robotAt(const QString& host) const;
    void rememberRobot(const RobotAddress& robot);
    void forgetRobot(const RobotAddress& robot);
    QString theme() const;  ///< "light" or "dark"; empty if the user never selected a theme
    void setTheme(const QString& theme);
    QByteArray windowGeometry() const;
    void setWindowGeometry(const QByteArray& geometry);
    /// The user's names of inputs and outputs, by terminal, e.g. "DI 0".
    QMap<QString, QString> ioNames() const;
    void setIoNames(const QMap<QString, QString>& names);
    /// The gripper of a robot in the format of GripperChoice::toText(); empty if there is none.
    /// robot  address of the robot, or "simulator"
    QString gripper(const QString& robot) const;
    void setGripper(const QString& robot, const QString& choice);
    /// Absolute paths, most recently used first. The files may no longer exist.
    QStringList recentProjects() const;
    void rememberProject(const QString& path);

    /// The arrangement of the plots in the format of PlotDock::arrangement(); empty if it was never changed.
    QByteArray plots() const;
    /// Memory limit of the plot history [bytes]; 0 if the user never selected a limit.
    std::size_t plotBudget() const;
    void setPlots(const QByteArray& arrangement, std::size_t budget);

    TutorialProgress learned() const;
    void setTutorialProgress(const TutorialProgress& learned);

    // When writing the following values, each window writes only the changes it has made, and keeps the other
    // entries of the file.

    /// Values of the settings page.
    Preferences preferences() const;
    void setPreferences(const Preferences& preferences);

    /// All values that may be transferred to another computer.
    SettingsBundle bundle() const;
    /// Replaces these parts completely, after writing the current settings to a backup file in the same
    /// folder. If the backup fails, nothing is changed.
    /// Returns  the path of the backup
    /// Errors   FileNotWritable, DiskFull
    Result<QString> replace(const SettingsBundle& bundle, const QSet<SettingsPart>& parts);
    /// The user's perspectives in the order of saving.
    QVector<SavedPerspective> perspectives() const;
    /// Returns  all perspectives, including those of other windows
    QVector<SavedPerspective> setPerspectives(const QVector<SavedPerspective>& all);
    /// The last saved arrangement of the panels.
    LastArrangement arrangement() const { return readArrangement(SettingsView(file_)); }
    void setArrangement(const LastArrangement& arrangement);

private:
    QString backupPath() const;
    /// Changes the current settings under a lock, which prevents other windows from writing.
    Result<void> edit(const std::function<void(SettingsEdit&)>& change);

    QString file_;
    std::function<void(const Error&)> writeFailed_;
    bool failed_ = false;
    // Values that this window last read or wrote. The window writes only values that differ from them.
    mutable std::optional<SettingsMap> knownPreferences_;
    mutable std::optional<SettingsMap> knownIoNames_;
    mutable std::optional<TutorialProgress> knownTutorial_;
    mutable std::optional<QVector<SavedPerspective>> knownPerspectives_;
};

}  // namespace tiller::app
