// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which project a start begins with when the command line names none.

#include <QString>

namespace tiller::app {

class Settings;

struct StartProject {
    QString path;     ///< to open, or to begin with: the file need not exist yet
    QString missing;  ///< the file worked in last, where it is not there any more; empty otherwise
};

/// The file worked in last. Where there is none: the file that earlier versions kept in the system's folder
/// for application data, else "cell.tiller" in projectFolder(), which is made.
StartProject startProject(const Settings& settings);

/// Where changes that are in no file survive the end of the program.
QString unsavedWorkFolder();

}  // namespace tiller::app
