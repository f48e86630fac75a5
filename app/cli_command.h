// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the commands of tiller-cli share.

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

/// A robot controller with a simulated arm, until the program is told to end.
int simulate(const QStringList& arguments);
/// A fault, by its words, at a simulated controller that runs somewhere.
int fault(const QStringList& arguments);
/// What stands between this PC and a robot that can be moved, one line a condition, or as JSON.
/// Returns  kFailed when something is bad. Blocks: up to twelve seconds
int doctor(const QStringList& arguments);
/// A robot's packages to a file, until told to end or for a time.
int record(const QStringList& arguments);
/// What is in a recording, as text or JSON.
int info(const QStringList& arguments);
/// A recording as CSV or HDF5.
int exportRecording(const QStringList& arguments);
/// A robot's packages to viewers, until told to end.
int serve(const QStringList& arguments);
/// Recordings as demonstrations to learn from.
int episodes(const QStringList& arguments);
/// A project: its content, its errors, or a conversion.
/// Returns  kFailed when a check finds an error
int projectCommand(const QStringList& arguments);
/// When the arm of a recording parted from its model.
int divergence(const QStringList& arguments);

}  // namespace tiller::app
