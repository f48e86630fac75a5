// SPDX-License-Identifier: MIT
#pragma once

// What the system grants a real-time program: affinity, locked memory, the kind of kernel; and how to get
// more. Priority is in thread_priority.h.

#include <QString>
#include <QStringList>
#include <vector>

#include "robot/realtime/thread_priority.h"

namespace tiller::realtime {

/// Binds the calling thread to these CPUs, counted from 0.
/// Returns  why it did not work; empty when it did
/// Threads  changes the calling thread. Windows: written to the documentation, not run. macOS has no such
/// call
QString bindToCpus(const std::vector<int>& cpus);

/// Keeps all memory of the process, present and to come, out of the swap, so that no page fault waits for a
/// disk.
/// Returns  why it did not work, with what to do; empty when it did
QString lockMemory();

/// True on a kernel with PREEMPT_RT (Linux: /sys/kernel/realtime, or its version says so).
bool isRealtimeKernel();

struct RealtimeReport {
    PriorityReport priority;
    bool memoryLocked = false;
    bool affinitySet = false;
    bool realtimeKernel = false;
    /// One line for each thing that was not granted, and how to get it; empty when all is well.
    QStringList advice;
};

/// Asks for all of it for the calling thread, and reports.
/// cpus  empty: leaves the thread where it is
RealtimeReport requestRealtime(int priority, const std::vector<int>& cpus = {}, bool lockAllMemory = true);

}  // namespace tiller::realtime
