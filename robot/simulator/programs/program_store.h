// SPDX-License-Identifier: MIT
#pragma once

// The programs folder of a controller and the loaded program, shared by the dashboard and the Robot API.
// Nothing outside that folder is read or written, whatever name a client sends, even through `..` or symbolic
// links. The folder is checked again at each access. Program files are:
//
// - `.urp` or `.urpx`, as saved by the pendant: the `.script` that the pendant saved next to it is run, or
// otherwise the result of pendant/pendant_program.h for its nodes;
// - any other file: URScript text.

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

/// Larger program files are rejected.
inline constexpr qint64 kLargestProgram = 16 << 20;

/// Threads  the simulator's.
class ProgramStore {
public:
    /// folder  empty: no programs until one is uploaded
    /// source  returns what is needed to read pendant programs; its files are those of the folder
    ProgramStore(QString folder, std::function<pendant::PendantSource()> source)
        : folder_(std::move(folder)), source_(std::move(source)) {}

    /// name  relative to the folder, or a full path; `/programs/` and `/ursim/programs/` refer to the folder
    /// Errors   FileNotReadable: no such file in the folder; FileCorrupt, with the reason: the program cannot
    /// be translated. The loaded program is unchanged on errors
    Result<void> load(const QString& name);
    /// Loads the installation for programs that do not name one. Every robot has a default.installation.
    /// Errors as load()
    Result<void> loadInstallation(const QString& name);
    /// The computer that provides the scripts of External Control nodes, according to the installation.
    ScriptProvider scriptProvider() const;

    /// Restores the state of a new controller, with no loaded program.
    void unload() {
        path_.clear();
        name_.clear();
    }
    bool isLoaded() const { return !path_.isEmpty(); }
    QString path() const { return path_; }
    /// File name without path.
    std::string name() const { return name_; }
    /// The loaded program, read again, as URScript.
    /// Errors   as load(), because the file may have changed since; FileCorrupt: the program is unfinished
    Result<std::string> script() const;

    /// Writes a file into an existing folder within the programs folder ("." is the folder itself).
    bool saveBelow(const QString& directory, const QString& bareName, const QByteArray& content) const;

    /// Files of the folder with this suffix, sorted by name.
    std::vector<QString> list(const QString& ending) const;
    /// The path of a file with this name, existing or not; empty for a name, or a link, that leads out of the
    /// folder.
    QString pathOf(const QString& bareName) const;
    /// Writes a file. Without a folder, creates a temporary one that is removed with this object.
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
