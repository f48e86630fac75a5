// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is left of a program that a signal ended: which signal, the calls that led there, and the last lines of the
// log. It is written by the dying process with what a signal handler may call, and offered at the next start.

#include <QByteArray>
#include <QString>

namespace tiller::app {

/// Where it is left for the user that is logged in.
QString crashReportPath();

/// From now on a crash leaves a report in this file, and then ends the process as it would have.
/// path  the folder is made if it is not there
/// Threads  GUI, once. On systems without backtrace() it does nothing
void keepCrashReports(const QString& path);

/// The next report tells this line among the last ones; of longer ones the beginning.
/// Threads  GUI
void rememberForCrash(const QString& line);

/// What an earlier process left; empty when none did, or when it cannot be read.
QByteArray readCrashReport(const QString& path);

}  // namespace tiller::app
