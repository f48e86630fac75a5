// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The project of a start without a project on the command line.

#include <QString>

namespace tiller::app {

class Settings;

struct StartProject {
    QString path;     ///< file to open or create; it may be missing
    QString missing;  ///< the last file if it no longer exists; otherwise empty
};

/// Returns the last file. If there is none: the file that earlier versions kept in the application data
/// folder, otherwise "cell.tiller" in projectFolder(), which is created.
StartProject startProject(const Settings& settings);

/// Folder for unsaved changes.
QString unsavedWorkFolder();

}  // namespace tiller::app
