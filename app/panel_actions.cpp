// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panel_actions.h"

#include "app/action_table.h"
#include "widgets/io/io_tab.h"
#include "widgets/log/log_tab.h"
#include "widgets/plots/plot_dock.h"
#include "widgets/plots/plot_view.h"

namespace tiller::app {

void PanelActions::addPlots(ActionTable& table, PlotDock& plots) {
    table.add({"plots.action.record",
               tr("Record"),
               tr("Writes every packet of the robot to a CSV file, until it is stopped."),
               {},
               [&plots] { plots.toggleRecording(); },
               [](const SessionState& s) {
                   return s.recording.active          ? tr("A recording runs already.")
                          : s.link != LinkState::Live ? tr("Connect to a robot first.")
                                                      : QString();
               }});
    table.add(
        {"plots.action.stopRecording",
         tr("Stop recording"),
         tr("Ends the recording; its file is complete."),
         {},
         [&plots] { plots.toggleRecording(); },
         [](const SessionState& s) { return s.recording.active ? QString() : tr("Nothing is recorded."); }});
    table.add({"plots.action.pause",
               tr("Pause or resume the plots"),
               tr("Holds the plots still; data and recording go on. Once more: back to the newest samples."),
               {},
               [&plots] { plots.setPaused(plots.view().window().follows()); }});
    table.add({"plots.action.export",
               tr("Export the plots…"),
               tr("Saves the shown range as a picture, a drawing, a page or values."),
               {},
               [&plots] { plots.askExport(); }});
    table.add(
        {"plots.action.signals",
         tr("Search signals for the plots"),
         tr("Opens the list of everything the robot tells: onto a plot by dragging, double click or Return."),
         {},
         [&plots] { plots.searchSignals(); }});
    table.add({"plots.action.addPage",
               tr("New page of plots"),
               tr("An empty page behind the others; all pages show the same time."),
               {},
               [&plots] { plots.addPage(); }});
    table.add({"plots.action.fit",
               tr("Show all of the plots' history"),
               tr("All that is in memory, each plot at its best scale."),
               {},
               [&plots] { plots.view().fit(); }});
    for (const PlotDock::Span& span : plots.spans()) {
        table.add({QStringLiteral("plots.action.span.%1").arg(span.seconds),
                   tr("Plots show %1").arg(span.text),
                   tr("How much time the plots show."),
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
               tr("Rename the chosen input or output"),
               tr("The row of the tab I/O that has the focus."),
               {},
               [&io] { io.renameChosen(); }});
    table.add({"io.action.switch",
               tr("Switch the chosen output"),
               tr("The output of the tab I/O that has the focus: on, or off again."),
               {},
               [&io] { io.switchChosen(); }});
    table.add({"io.action.pulse",
               tr("Pulse the chosen output"),
               tr("The output of the tab I/O that has the focus: on for half a second, then off."),
               {},
               [&io] { io.pulseChosen(); }});
}

void PanelActions::addLog(ActionTable& table, LogTab& log, const std::function<void()>& bringToFront) {
    table.add({"log.action.search",
               tr("Search the log"),
               tr("Shows only the lines with these words."),
               {},
               [&log, bringToFront] {
                   bringToFront();
                   log.focusSearch();
               }});
    const std::pair<Severity, QString> kinds[] = {{Severity::Info, tr("Log: show all")},
                                                  {Severity::Warning, tr("Log: show warnings and worse")},
                                                  {Severity::Error, tr("Log: show errors")}};
    for (const auto& [severity, text] : kinds) {
        table.add({QStringLiteral("log.action.from.%1").arg(static_cast<int>(severity)),
                   text,
                   tr("Chooses which lines of the log are shown."),
                   {},
                   [&log, bringToFront, severity = severity] {
                       bringToFront();
                       log.showFrom(severity);
                   }});
    }
    table.add({"log.action.copy",
               tr("Copy the log"),
               tr("Copies the selected lines, or all that are shown."),
               {},
               [&log] { log.copy(); }});
    table.add({"log.action.export",
               tr("Export the log…"),
               tr("Writes the lines that are shown to a file."),
               {},
               [&log] { log.exportToFile(); }});
}

}  // namespace tiller::app
