// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The project to open if the command line does not specify one.

#include <QString>

namespace tiller::app {

class Settings;

struct StartProject {
    QString path;     ///< file to open or create; the file may not exist
    QString missing;  ///< path of the last file if that file does not exist; otherwise empty
};

/// Returns the last file. If there is none, returns the file of earlier versions in the application data
/// folder. If that does not exist either, returns "cell.tiller" in projectFolder(), which is created.
StartProject startProject(const Settings& settings);

QString unsavedWorkFolder();

}  // namespace tiller::app
