// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The project that is opened if no project is given on the command line.

#include <QString>

namespace tiller::app {

class Settings;

struct StartProject {
    QString path;     ///< file to open or create; the file may not exist
    QString missing;  ///< path of the last file if that file no longer exists; otherwise empty
};

/// Returns the last file. If there is none, returns the file that earlier versions kept in the application
/// data folder, otherwise "cell.tiller" in projectFolder(), which is created.
StartProject startProject(const Settings& settings);

QString unsavedWorkFolder();

}  // namespace tiller::app
