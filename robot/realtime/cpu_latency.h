// SPDX-License-Identifier: MIT
#pragma once

// Keeps the processors from falling into a deep sleep that they need long to wake up from.

#include <QString>

namespace tiller::realtime {

/// As long as one of these lives the system is asked for wake-ups without delay (Linux: 0 us written to
/// /dev/cpu_dma_latency, which the process holds open). An idle machine then takes more power.
/// Threads  any: one request serves all of the process
class CpuLatency {
public:
    CpuLatency();
    ~CpuLatency();
    CpuLatency(const CpuLatency&) = delete;
    CpuLatency& operator=(const CpuLatency&) = delete;

    /// False where the system has no such thing or does not permit it: advice() says which, and all goes on without.
    bool isGranted() const { return granted_; }
    /// Why it would not be granted to this process, and how to permit it; empty when it would be, or is.
    static QString advice();

private:
    bool granted_;
};

}  // namespace tiller::realtime
