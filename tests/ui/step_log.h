// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Log of the last steps of a long test, so that a failure can be reproduced. Also printed after a crash, a
// qFatal or a timeout of Qt Test.

#include <QString>
#include <QStringList>

namespace tiller::test {

/// Only one log is active at a time. The functions are called from the GUI thread only, but a crash may occur
/// in any thread.
class StepLog {
public:
    static constexpr int kKept = 30;

    /// Clears the log.
    /// title  printed before the steps; contains the settings that reproduce the steps
    static void begin(const QString& title);
    static void add(const QString& step);
    /// The title and the last steps, oldest first.
    static QString text();
    /// Makes a crash print the log to the standard error output before the normal crash handling. No effect
    /// on systems without signals.
    static void printOnCrash();
};

}  // namespace tiller::test
