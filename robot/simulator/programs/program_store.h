// SPDX-License-Identifier: MIT
#pragma once

// The programs folder of a controller and the loaded program, shared by the dashboard and the Robot API. No
// file outside that folder is read or written, even if the name sent by a client contains `..` or leads
// through symbolic links. The folder is checked at each access. Program files are:
//
// - `.urp` or `.urpx` files saved by the teach pendant. The `.script` file that the teach pendant saved with
//   the program runs. If there is none, pendant/pendant_program.h translates the nodes.
// - Any other file, which contains URScript text.

#include <QString>
#include <QTemporaryDir>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/simulator/pendant/pendant_program.h"
#include "robot/simulator/programs/external_control.h"

namespace tiller::simulator {

/// Maximum size of a program file [bytes]. Larger files are refused.
inline constexpr qint64 kLargestProgram = 16 << 20;

/// Threads  the simulator thread
class ProgramStore {
public:
    /// folder  empty: no programs until a program is uploaded
    /// source  returns the data needed to read pendant programs; its files are in the folder
    ProgramStore(QString folder, std::function<pendant::PendantSource()> source)
        : folder_(std::move(folder)), source_(std::move(source)) {}

    /// name  relative to the folder, or a full path; `/programs/` and `/ursim/programs/` refer to the folder
    /// Errors   FileNotReadable: no such file in the folder; FileCorrupt, with the reason: the program cannot
    ///          be translated. After an error, the loaded program is unchanged
    Result<void> load(const QString& name);
    /// Loads the installation for programs that do not name one. Every robot has a default.installation.
    /// Errors   same as load()
    Result<void> loadInstallation(const QString& name);
    /// Address of the PC that provides the scripts of External Control nodes, from the installation.
    ScriptProvider scriptProvider() const;

    /// Unloads the program, as on a new controller.
    void unload() {
        path_.clear();
        name_.clear();
    }
    bool isLoaded() const { return !path_.isEmpty(); }
    QString path() const { return path_; }
    /// File name without a path.
    std::string name() const { return name_; }
    /// Reads the loaded program again and returns it as URScript.
    /// Errors   same as load(), because the file may have changed; FileCorrupt if the program is unfinished
    Result<std::string> script() const;

    /// Writes a file into an existing folder within the programs folder; "." is the programs folder.
    bool saveBelow(const QString& directory, const QString& bareName, const QByteArray& content) const;

    /// Files of the folder with this suffix, sorted by name.
    std::vector<QString> list(const QString& ending) const;
    /// Path of a file with this name, which need not exist. Empty if the name or a link leads out of the
    /// folder.
    QString pathOf(const QString& bareName) const;
    /// Writes a file. If no folder is set, creates a temporary folder that is removed with this object.
    bool save(const QString& bareName, const QByteArray& content);

private:
    std::optional<QString> find(const QString& name) const;
    bool isWithin(const QString& path) const;
    std::optional<QByteArray> read(const QString& name) const;
    std::optional<QByteArray> readPath(const QString& path) const;
    Result<pendant::PendantProgram> programAt(const QString& path) const;

    QString folder_;
    std::function<pendant::PendantSource()> source_;
    QString installation_ = QStringLiteral("default.installation");
    std::unique_ptr<QTemporaryDir> own_;
    QString path_;
    std::string name_;
};

}  // namespace tiller::simulator
