// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The command line of `tiller`. Error messages include the valid values.

#include <QString>
#include <QStringList>

#include "robot/core/result.h"

namespace tiller::app {

struct CommandLine {
    enum class Start { Ask, Simulator, Robot };
    Start start = Start::Ask;  ///< Ask: shows the connection dialog
    QString robotHost;
    QString
        demoDirectory;    ///< folder for files of the scripted demonstration; if not empty, runs it and exits
    QString projectFile;  ///< project to open; empty: the last project
    QStringList recordings;
    QString theme;             ///< "light", "dark", or empty for the last setting
    bool monitorOnly = false;  ///< blocks all changes on the robot, regardless of the settings
    bool showHelp = false;
    bool showVersion = false;
    QString helpText;
};

/// True if the extension is that of a recording; see recording::fileFormats().
bool isRecordingName(const QString& path);

/// Errors  InvalidArgument with the argument and its valid values in the context
Result<CommandLine> parseCommandLine(const QStringList& arguments);

}  // namespace tiller::app
