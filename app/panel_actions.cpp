// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panel_actions.h"

#include <QMenu>

#include "app/action_table.h"
#include "app/dock_stage.h"
#include "app/panel_dock.h"
#include "robot/station/history/signal_store.h"
#include "widgets/io/io_tab.h"
#include "widgets/log/log_tab.h"
#include "widgets/plots/plot_dock.h"
#include "widgets/plots/plot_view.h"

namespace tiller::app {

void PanelActions::addPlots(ActionTable& table, PlotDock& plots) {
    table.add({"plots.action.record",
               tr("Record"),
               tr("Records the robot data to a file until you stop the recording."),
               {},
               [&plots] { plots.toggleRecording(); },
               [](const SessionState& s) {
                   return s.recording.active          ? tr("A recording is already running.")
                          : s.link != LinkState::Live ? tr("Connect to a robot first.")
                                                      : QString();
               }});
    table.add({"plots.action.stopRecording",
               tr("Stop recording"),
               tr("Stops the recording and completes its file."),
               {},
               [&plots] { plots.toggleRecording(); },
               [](const SessionState& s) {
                   return s.recording.active ? QString() : tr("No recording is running.");
               }});
    table.add({"plots.action.pause",
               tr("Pause or resume the plots"),
               tr("Freezes the plots while data and recording continue. Press again to return to the newest "
                  "samples."),
               {},
               [&plots] { plots.setPaused(plots.view().window().follows()); }});
    table.add({"plots.action.note",
               tr("Add note…"),
               tr("Adds a note at the selected cursor if it is visible, otherwise at the end of the plots."),
               {},
               [&plots] { plots.askForNote(plots.view().noteTime()); }});
    table.add({"plots.action.export",
               tr("Export the plots…"),
               tr("Saves the visible range as an image, PDF page or table of values."),
               {},
               [&plots] { plots.askExport(); }});
    table.add({"plots.action.signals",
               tr("Search plot signals"),
               tr("Opens the list of all signals. To add a signal to a plot, drag it, double-click it or "
                  "press Return."),
               {},
               [&plots] { plots.searchSignals(); }});
    table.add({"plots.action.addPage",
               tr("New plot page"),
               tr("Adds an empty page at the end. All pages share the time axis."),
               {},
               [&plots] { plots.addPage(); }});
    table.add({"plots.action.fit",
               tr("Show the entire history"),
               tr("Shows all data in memory and scales each plot automatically."),
               {},
               [&plots] { plots.view().fit(); }});
    table.add({"plots.action.standard",
               tr("Show standard plots"),
               tr("Replaces the pages of live data with the standard page. Pages with recordings are kept."),
               {},
               [&plots] { plots.showStandard(); }});
    table.add({"plots.action.openRecording",
               tr("Open recording…"),
               tr("Shows a recording or a table of another program on its own page."),
               {},
               [&plots] { plots.askForRecording(); }});
    table.add({"plots.action.closeRecordings",
               tr("Close recordings"),
               tr("Removes all opened recordings from the plots. The files are kept."),
               {},
               [&plots] { plots.closeRecordings(); },
               [&plots](const SessionState&) {
                   return plots.store().hasRecordings() ? QString() : tr("No recording is open.");
               }});
    table.add(
        {"plots.action.play",
         tr("Plots: start or stop playback"),
         tr("Moves cursor A in real time through the recording or the paused plots. The Layout menu contains "
            "other speeds."),
         {},
         [&plots] {
             if (plots.isPlaying()) {
                 plots.stopPlayback();
             } else {
                 plots.play(1);
             }
         }});
    table.add({"plots.action.compare",
               tr("Compare with the arm model…"),
               tr("Compares the displayed recording with the model of its arm."),
               {},
               [&plots] { plots.compareWithModel(); },
               [&plots](const SessionState&) {
                   return plots.isRecordingInFront() ? QString() : tr("Show the page of a recording first.");
               }});
    table.add({"plots.action.values",
               tr("Values at the cursors"),
               tr("Shows or hides the table of values at the cursors and between them."),
               {},
               [&plots] { plots.setValuesShown(!plots.isValuesShown()); }});
    table.add({"plots.action.analysis",
               tr("Spectrum and XY"),
               tr("Shows or hides the spectrum and the XY plot of two signals."),
               {},
               [&plots] { plots.setAnalysisShown(!plots.isAnalysisShown()); }});
    for (const PlotDock::Span& span : plots.spans()) {
        table.add({QStringLiteral("plots.action.span.%1").arg(span.seconds),
                   tr("Plots: last %1").arg(span.text),
                   tr("Sets the time range of the plots."),
                   {},
                   [&plots, seconds = span.seconds] { plots.view().setSpan(seconds); }});
    }
}

void PanelActions::addIo(ActionTable& table, IoTab& io, const std::function<void()>& bringToFront) {
    table.add({"io.action.search",
               tr("Search inputs and outputs"),
               tr("Finds a terminal or a register by its number or name."),
               {},
               [&io, bringToFront] {
                   bringToFront();
                   io.focusSearch();
               }});
    table.add({"io.action.rename",
               tr("Rename selected input or output"),
               tr("Renames the input or output in the selected row of the I/O tab."),
               {},
               [&io] { io.renameChosen(); }});
    table.add({"io.action.switch",
               tr("Switch selected output"),
               tr("Switches the selected output on the I/O tab on or off."),
               {},
               [&io] { io.switchChosen(); }});
    table.add({"io.action.pulse",
               tr("Pulse selected output"),
               tr("Switches the selected output on the I/O tab on for 0.5 s, then off."),
               {},
               [&io] { io.pulseChosen(); }});
}

void PanelActions::addLog(ActionTable& table, LogTab& log, const std::function<void()>& bringToFront) {
    table.add({"log.action.search",
               tr("Search the log"),
               tr("Shows only entries that contain the search text."),
               {},
               [&log, bringToFront] {
                   bringToFront();
                   log.focusSearch();
               }});
    const std::pair<Severity, QString> kinds[] = {{Severity::Info, tr("Log: show all")},
                                                  {Severity::Warning, tr("Log: show warnings and errors")},
                                                  {Severity::Error, tr("Log: show errors only")}};
    for (const auto& [severity, text] : kinds) {
        table.add({QStringLiteral("log.action.from.%1").arg(static_cast<int>(severity)),
                   text,
                   tr("Selects which log entries are shown."),
                   {},
                   [&log, bringToFront, severity = severity] {
                       bringToFront();
                       log.showFrom(severity);
                   }});
    }
    table.add({"log.action.copy",
               tr("Copy the log"),
               tr("Copies the selected entries. If no entry is selected, copies all visible entries."),
               {},
               [&log] { log.copy(); }});
    table.add(
        {"log.action.export", tr("Export the log…"), tr("Writes the visible entries to a file."), {}, [&log] {
             log.exportToFile();
         }});
}

void PanelActions::addDock(ActionTable& table, DockStage& stage, PanelDock& dock,
                           const std::function<void()>& menuOpens) {
    const QString name = dock.objectName();
    QAction* toggle = dock.toggleViewAction();
    toggle->setObjectName("view.toggle." + name);
    toggle->setText(tr("Show or hide %1").arg(dock.windowTitle()));
    table.adopt("view", toggle);
    QAction* floats = table.add(
        {"view.float." + name,
         tr("Float %1").arg(dock.windowTitle()),
         tr("Moves the panel to a separate window, e.g. on a second screen, or back to the main window."),
         {},
         [&dock] {
             // Call this later, because it may destroy the window to which Qt is still delivering key events.
             QMetaObject::invokeMethod(
                 &dock,
                 [&dock] {
                     if (dock.isFloating()) {
                         dock.show();
                         dock.setFloating(false);
                     } else {
                         dock.floatFree();
                     }
                 },
                 Qt::QueuedConnection);
         }});
    dock.menu().addActions({floats, toggle});
    dock.menu().addSeparator();
    const auto move = [&](const char* where, const QString& text, StageSide side) {
        dock.menu().addAction(table.add({QStringLiteral("panel.%1.%2").arg(name, QLatin1String(where)),
                                         text.arg(dock.windowTitle()),
                                         tr("Moves the panel to this side of the main window."),
                                         {},
                                         [&stage, &dock, side] { stage.move(dock, side); }}));
    };
    move("left", tr("%1 to the left"), StageSide::Left);
    move("right", tr("%1 to the right"), StageSide::Right);
    move("top", tr("%1 to the top"), StageSide::Top);
    move("bottom", tr("%1 to the bottom"), StageSide::Bottom);
    QObject::connect(&dock.menu(), &QMenu::aboutToShow, &dock, menuOpens);
}

}  // namespace tiller::app
