// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What `tiller` was asked on its command line. A wrong argument is answered with what would be right.

#include <QString>
#include <QStringList>

#include "robot/core/result.h"

namespace tiller::app {

struct CommandLine {
    enum class Start { Ask, Simulator, Robot };
    Start start = Start::Ask;  ///< Ask: the connect dialog
    QString robotHost;
    QString demoDirectory;     ///< not empty: run the scripted demonstration, leave its files there, exit
    QString projectFile;       ///< to open; empty: the one worked in last
    QString theme;             ///< "light", "dark" or empty: as last time
    bool monitorOnly = false;  ///< the window changes nothing on the robot, whatever the settings say
    bool showHelp = false;
    bool showVersion = false;
    QString helpText;
};

/// Errors  InvalidArgument, with the argument and what it should look like in the context
Result<CommandLine> parseCommandLine(const QStringList& arguments);

}  // namespace tiller::app
