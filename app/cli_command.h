// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Functions of the tiller-cli commands.

#include <QStringList>
#include <QTextStream>

namespace tiller::app {

enum ExitCode { kSuccess = 0, kFailed = 1, kWrongArguments = 2 };

inline QTextStream& out() {
    static QTextStream stream(stdout);
    return stream;
}
inline int complain(const QString& what, ExitCode code) {
    QTextStream(stderr) << "tiller-cli: " << what << '\n';
    return code;
}
inline int wrongArguments(const QString& what) {
    return complain(what + QStringLiteral("\nSee 'tiller-cli --help'."), kWrongArguments);
}

/// Runs a controller with a simulated arm until the process is terminated.
int simulate(const QStringList& arguments);
/// Triggers a named fault in a running simulated controller.
int fault(const QStringList& arguments);
/// Prints the conditions for moving a robot from this PC, one line each, or as JSON.
/// Returns  kFailed if a condition is not met. Blocks: up to twelve seconds
int doctor(const QStringList& arguments);
/// Records the packages of a robot to a file, for a given time or until the process is terminated.
int record(const QStringList& arguments);
/// Prints the content of a recording as text or JSON.
int info(const QStringList& arguments);
int exportRecording(const QStringList& arguments);
/// Publishes the packages of a robot to viewers until the process is terminated.
int serve(const QStringList& arguments);
/// Exports recordings as demonstrations for machine learning.
int episodes(const QStringList& arguments);
/// Shows the content of a project, checks it, or converts it.
/// Returns  kFailed if a check finds an error
int projectCommand(const QStringList& arguments);
/// Finds the time at which the arm in a recording deviates from its model.
int divergence(const QStringList& arguments);

}  // namespace tiller::app
