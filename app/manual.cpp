// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/manual.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QWidget>
#include <algorithm>

namespace tiller::app {

const QVector<ManualPlace>& manualPlaces() {
    static const QVector<ManualPlace> all = [] {
        const std::pair<const char*, const char*> places[] = {
            {"headerBar", "window/header.html"},
            {"jogColumn", "window/jog.html"},
            {"deviceTrainer", "window/jog.html#keyboard-gamepad-spacemouse"},
            {"view", "window/view.html"},
            {"firstSteps", "simulator.html"},
            {"practice", "simulator.html"},
            {"sampleDialog", "simulator.html"},
            {"waypoints", "window/waypoints.html"},
            {"waypoint.route", "window/going_through.html"},
            {"waypoint.actions", "window/going_through.html#actions"},
            {"waypoint.properties", "window/waypoints.html#several"},
            {"waypoint.shift", "window/waypoints.html#several"},
            {"waypoint.history", "window/waypoints.html#history"},
            {"pattern", "window/patterns.html"},
            {"program.tab", "programs.html"},
            {"frames", "window/frames.html"},
            {"tools", "window/tools.html"},
            {"payload.page", "window/tools.html#payloads"},
            {"position.page", "window/tools.html#positions"},
            {"io", "window/io.html"},
            {"gripper", "window/io.html#gripper"},
            {"log", "window/log.html"},
            {"plots", "window/plots.html"},
            {"plots.record", "window/plots.html#recording"},
            {"plots.recordMenu", "window/plots.html#recording"},
            {"programDialog", "window/header.html#programs"},
            {"commandPalette", "window/panels.html#commands"},
            {"perspectiveDialog", "window/panels.html#perspectives"},
            {"perspectiveDelete", "window/panels.html#perspectives"},
            {"connectDialog", "window/connecting.html"},
            {"preflightPage", "window/connecting.html#before-you-connect"},
            {"recoveryPage", "window/recovery.html"},
            {"robotPopup", "window/recovery.html"},
            {"settingsPage", "window/settings.html"},
            {"importSettings", "window/settings.html"},
            {"reportDialog", "reports.html"},
        };
        QVector<ManualPlace> made;
        for (const auto& [widget, page] : places) {
            made.append({QString::fromLatin1(widget), QString::fromLatin1(page)});
        }
        return made;
    }();
    return all;
}

QString manualPageOf(const QWidget* focus) {
    for (; focus != nullptr; focus = focus->parentWidget()) {
        const auto place = std::ranges::find(manualPlaces(), focus->objectName(), &ManualPlace::widget);
        if (place != manualPlaces().end()) {
            return place->page;
        }
    }
    return QStringLiteral("index.html");
}

QString manualFolder() {
    const QString contents = QStringLiteral("tiller/manual/index.html");
    const QString beside = QDir::cleanPath(QCoreApplication::applicationDirPath() + "/../share/" + contents);
    const QString found = QFileInfo::exists(beside)
                              ? beside
                              : QStandardPaths::locate(QStandardPaths::GenericDataLocation, contents);
    return found.isEmpty() ? QString() : QFileInfo(found).absolutePath();
}

}  // namespace tiller::app
