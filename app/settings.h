// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the program remembers between two starts. Never a speed: every start begins slowly.

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

/// What a newcomer has done so far, by name.
struct Learned {
    bool dismissed = false;  ///< the checklist of the first steps does not come by itself any more
    QStringList firstSteps;
    QStringList practice;
};

class Settings {
public:
    /// file  where they are kept; empty: the place the system has for them
    explicit Settings(QString file = {});

    /// Called when something could not be written, once until writing works again.
    void setWriteFailed(std::function<void(const Error&)> tell) { writeFailed_ = std::move(tell); }

    /// Newest first. The simulated robot is none of them.
    QVector<RobotAddress> rememberedRobots() const;
    void rememberRobot(const RobotAddress& robot);
    void forgetRobot(const RobotAddress& robot);
    QString theme() const;  ///< "light" or "dark"; empty when never chosen
    void setTheme(const QString& theme);
    QByteArray windowGeometry() const;
    void setWindowGeometry(const QByteArray& geometry);
    /// The operator's names of inputs and outputs, by terminal: "DI 0".
    QMap<QString, QString> ioNames() const;
    void setIoNames(const QMap<QString, QString>& names);
    /// The gripper of a robot, by its address or "simulator"; empty: none. As GripperChoice::toText() has it.
    QString gripper(const QString& robot) const;
    void setGripper(const QString& robot, const QString& choice);
    /// Absolute paths, the one worked in last first. The files may be gone.
    QStringList recentProjects() const;
    void rememberProject(const QString& path);

    /// Which plots there are, as PlotDock::arrangement() has it; empty when never changed.
    QByteArray plots() const;
    /// How much memory the plots' history may take [bytes]; 0 when never chosen.
    std::size_t plotBudget() const;
    void setPlots(const QByteArray& arrangement, std::size_t budget);

    Learned learned() const;
    void setLearned(const Learned& learned);

    // Of these, several windows each write what they have changed themselves and keep the other entries of the file.

    /// What the settings page offers.
    Preferences preferences() const;
    void setPreferences(const Preferences& preferences);

    /// Everything that may go to another computer.
    SettingsBundle bundle() const;
    /// Replaces these parts as a whole. What is there now is written to a file first, beside the settings; when
    /// that fails, nothing is changed.
    /// Returns  the path of that file
    /// Errors  FileNotWritable, DiskFull
    Result<QString> replace(const SettingsBundle& bundle, const QSet<SettingsPart>& parts);
    /// The operator's own perspectives, in the order of saving.
    QVector<SavedPerspective> perspectives() const;
    /// Returns  all there are now, those of other windows included
    QVector<SavedPerspective> setPerspectives(const QVector<SavedPerspective>& all);
    /// How the panels stood when the window was closed last.
    LastArrangement arrangement() const { return readArrangement(SettingsView(file_)); }
    void setArrangement(const LastArrangement& arrangement);

private:
    QString backupPath() const;
    /// Changes the newest settings while no other window writes.
    Result<void> edit(const std::function<void(SettingsEdit&)>& change);

    QString file_;
    std::function<void(const Error&)> writeFailed_;
    bool failed_ = false;
    // What this window last read or wrote: only what differs from it is written.
    mutable std::optional<SettingsMap> knownPreferences_;
    mutable std::optional<SettingsMap> knownIoNames_;
    mutable std::optional<Learned> knownLearned_;
    mutable std::optional<QVector<SavedPerspective>> knownPerspectives_;
};

}  // namespace tiller::app
