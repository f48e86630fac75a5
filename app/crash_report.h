// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Crash reports with the signal, the call stack and the last lines of the log. The crashing process writes
// the report with async-signal-safe functions only. At the next start, the application offers the report to
// the user.

#include <QByteArray>
#include <QString>

namespace tiller::app {

/// Path of the crash report of the current user.
QString crashReportPath();

/// Installs a handler that writes a report to this file if the process crashes.
/// path     missing folders are created
/// Threads  GUI; call once. Has no effect on systems without backtrace()
void keepCrashReports(const QString& path);

/// Adds a log line to a possible crash report. Long lines are truncated.
/// Threads  GUI
void rememberForCrash(const QString& line);

/// Returns the crash report of an earlier process; empty if it does not exist or cannot be read.
QByteArray readCrashReport(const QString& path);

}  // namespace tiller::app
