// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The functions of the panels, the plots and the tabs I/O and Log as commands, for the menus and the command
// list.

#include <QCoreApplication>
#include <functional>

namespace tiller {
class IoTab;
class LogTab;
class PlotDock;
}  // namespace tiller

namespace tiller::app {

class ActionTable;
class DockStage;
class PanelDock;

struct PanelActions {
    Q_DECLARE_TR_FUNCTIONS(PanelActions)

public:
    /// Adds the commands that show, float and move a panel to the table and to the menu of the panel.
    /// menuOpens  called before the menu of the panel opens
    static void addDock(ActionTable& table, DockStage& stage, PanelDock& dock,
                        const std::function<void()>& menuOpens);
    static void addPlots(ActionTable& table, PlotDock& plots);
    static void addIo(ActionTable& table, IoTab& io, const std::function<void()>& bringToFront);
    static void addLog(ActionTable& table, LogTab& log, const std::function<void()>& bringToFront);
};

}  // namespace tiller::app
