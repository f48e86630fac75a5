// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/start_project.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include "app/settings.h"
#include "widgets/project/project_files.h"

namespace tiller::app {
namespace {

constexpr char kFirstName[] = "cell.tiller";

}  // namespace

QString unsavedWorkFolder() {
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation))
        .filePath(QStringLiteral("Unsaved"));
}

StartProject startProject(const Settings& settings) {
    StartProject start;
    for (const QString& path : settings.recentProjects()) {
        if (QFileInfo::exists(path)) {
            start.path = path;
            return start;
        }
        if (start.missing.isEmpty()) {
            start.missing = path;
        }
    }
    const QDir data(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation));
    if (data.exists(QLatin1String(kFirstName))) {
        start.path = data.filePath(QLatin1String(kFirstName));
        return start;
    }
    QDir().mkpath(projectFolder());
    start.path = QDir(projectFolder()).filePath(QLatin1String(kFirstName));
    if (start.missing == start.path) {
        start.missing.clear();  // a new project at this path was never saved, so no data are missing
    }
    return start;
}

}  // namespace tiller::app
