// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Crash reports: the signal, the call stack and the last lines of the log. The crashing process writes the report
// with async-signal-safe functions; the next start offers it to the user.

#include <QByteArray>
#include <QString>

namespace tiller::app {

/// Path of the report of the current user.
QString crashReportPath();

/// Makes a crash write a report to this file before the process terminates.
/// path     missing folders are created
/// Threads  GUI, once. No effect on systems without backtrace()
void keepCrashReports(const QString& path);

/// Adds a log line to the next report; long lines are truncated.
/// Threads  GUI
void rememberForCrash(const QString& line);

/// The report of an earlier process; empty if there is none or it cannot be read.
QByteArray readCrashReport(const QString& path);

}  // namespace tiller::app
