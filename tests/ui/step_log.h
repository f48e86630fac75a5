// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The last steps of a test that does many, so that a person can replay what broke it; also when it broke by a
// crash, a qFatal or a hang that Qt Test ends.

#include <QString>
#include <QStringList>

namespace tiller::test {

/// One of them is written to at a time. Threads  GUI; a crash may be anywhere.
class StepLog {
public:
    static constexpr int kKept = 30;

    /// Forgets all. title  stands above the steps: what to set to play them again
    static void begin(const QString& title);
    static void add(const QString& step);
    /// The title and the last steps, oldest first.
    static QString text();
    /// From now on a crash prints them to the standard error before it goes on as before. Where there are no
    /// signals this does nothing.
    static void printOnCrash();
};

}  // namespace tiller::test
