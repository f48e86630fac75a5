// SPDX-License-Identifier: MIT
#pragma once

// Real-time features granted by the system (CPU affinity, locked memory, type of kernel), with advice on how
// to enable them. For priorities, see thread_priority.h.

#include <QString>
#include <QStringList>
#include <vector>

#include "robot/platform/thread_priority.h"

namespace tiller::realtime {

/// Binds the calling thread to these CPUs, counted from 0.
/// Returns  the reason for a failure; empty on success
/// Threads  changes the calling thread. Windows: implemented from the documentation, not tested. macOS: not
/// supported
QString bindToCpus(const std::vector<int>& cpus);

/// Locks all current and future memory of the process, so that no page fault causes a disk access.
/// Returns  the reason for a failure and how to correct it; empty on success
QString lockMemory();

/// True on a kernel with PREEMPT_RT (Linux: from /sys/kernel/realtime or the version string).
bool isRealtimeKernel();

struct RealtimeReport {
    PriorityReport priority;
    bool memoryLocked = false;
    bool affinitySet = false;
    bool realtimeKernel = false;
    /// One line per refused feature with instructions; empty if all were granted.
    QStringList advice;
};

/// Requests all features for the calling thread.
/// cpus  empty: no affinity
RealtimeReport requestRealtime(int priority, const std::vector<int>& cpus = {}, bool lockAllMemory = true);

}  // namespace tiller::realtime
