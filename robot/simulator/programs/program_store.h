// SPDX-License-Identifier: MIT
#pragma once

// The programs folder of a controller and the program that is loaded from it, which the dashboard and the
// Robot API share. Nothing outside that folder is read or written, whatever a client names and wherever `..`
// or a symbolic link may lead; the folder is looked at anew each time. A program file is one of
//
// - `.urp` or `.urpx`, as the pendant saves it: the `.script` the pendant saved beside it runs, or else what
//   pendant/pendant_program.h makes of its nodes;
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

/// Larger program files are not read.
inline constexpr qint64 kLargestProgram = 16 << 20;

/// Threads  the simulator's.
class ProgramStore {
public:
    /// folder  empty: there are no programs, until one is uploaded
    /// source  returns what programs of the pendant are read with; its files are those of the folder
    ProgramStore(QString folder, std::function<pendant::PendantSource()> source)
        : folder_(std::move(folder)), source_(std::move(source)) {}

    /// name  relative to the folder, or its full path; `/programs/` and `/ursim/programs/` mean the folder
    /// Errors   FileNotReadable: there is no such file within the folder; FileCorrupt: it cannot be told what
    ///          the program does, with the reason. Nothing changes then
    Result<void> load(const QString& name);
    /// The installation of programs that name none. Every robot has a default.installation. Errors as load()
    Result<void> loadInstallation(const QString& name);
    /// Of the installation: who is asked for the scripts of External Control nodes.
    ScriptProvider scriptProvider() const;

    /// As a fresh controller: nothing is loaded.
    void unload() {
        path_.clear();
        name_.clear();
    }
    bool isLoaded() const { return !path_.isEmpty(); }
    QString path() const { return path_; }
    /// Bare file name.
    std::string name() const { return name_; }
    /// The loaded program, read again, as URScript.
    /// Errors   as load(): it may have changed since; FileCorrupt: the program is unfinished
    Result<std::string> script() const;

    /// Writes a file into an existing folder within the programs folder ("." is that one itself).
    bool saveBelow(const QString& directory, const QString& bareName, const QByteArray& content) const;

    /// Files of the folder with this ending, by name.
    std::vector<QString> list(const QString& ending) const;
    /// Where a file of that bare name is or would be; empty for a name, or a link, that leads out of the
    /// folder.
    QString pathOf(const QString& bareName) const;
    /// Writes a file; makes a folder of its own that goes with this object when there is none.
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
