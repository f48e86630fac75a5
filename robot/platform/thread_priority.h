// SPDX-License-Identifier: MIT
#pragma once

// Requests a priority for the calling thread and reports the result.

#include <QString>

namespace tiller::realtime {

struct PriorityReport {
    int requested = 0;
    /// Granted priority: on Linux the SCHED_FIFO priority, 0 for the normal scheduler.
    int granted = 0;
    /// True if at least the requested priority was granted.
    bool ok() const { return granted >= requested; }
    /// The reason for a refusal and how to correct it; empty if granted.
    QString advice;
};

/// priority  1 ... 99 on the SCHED_FIFO scale of Linux; other systems use their nearest class. 0 requests no
///           change.
/// Threads   changes the calling thread. Real-time: no
PriorityReport requestThreadPriority(int priority);

/// Sets the thread name shown by debuggers and `top -H`; truncated to 15 characters on Linux.
void nameThread(const char* name);

/// Processor time used by the calling thread [s]; 0 if the system does not report it.
double threadSeconds();

}  // namespace tiller::realtime
