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

/// Returns the most recently used project file that exists. If there is none, returns cell.tiller in the
/// application data folder (used by earlier versions) if it exists, otherwise in projectFolder(), and creates
/// that folder.
StartProject startProject(const Settings& settings);

QString unsavedWorkFolder();

}  // namespace tiller::app
