// SPDX-License-Identifier: MIT
#pragma once

// Asking the system to run the calling thread before others, and saying honestly what came of it.

#include <QString>

namespace tiller::realtime {

struct PriorityReport {
    int requested = 0;
    /// What the thread runs with: on Linux the SCHED_FIFO priority, 0 for the normal scheduler.
    int granted = 0;
    bool ok() const { return granted >= requested; }  ///< As wished for, or higher.
    /// Why it was not granted and what to do about it; empty when it was.
    QString advice;
};

/// priority  1 ... 99 on the SCHED_FIFO scale of Linux; other systems use their nearest class. 0 asks for
///           nothing.
/// Threads   changes the calling thread. Real-time: no
PriorityReport requestThreadPriority(int priority);

/// Shown by debuggers and `top -H`; cut to 15 characters on Linux.
void nameThread(const char* name);

/// Processor time the calling thread has used [s]; 0 where the system cannot tell.
double threadSeconds();

}  // namespace tiller::realtime
