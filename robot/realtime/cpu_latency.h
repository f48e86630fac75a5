// SPDX-License-Identifier: MIT
#pragma once

// Keeps the CPUs out of deep sleep states, which have long wake-up times.

#include <QString>

namespace tiller::realtime {

/// While an object of this class exists, it requests immediate CPU wake-ups from the system (Linux: the
/// process keeps /dev/cpu_dma_latency open with the value 0 us). This increases the power consumption of an
/// idle machine.
/// Threads  any; one request serves the whole process
class CpuLatency {
public:
    CpuLatency();
    ~CpuLatency();
    CpuLatency(const CpuLatency&) = delete;
    CpuLatency& operator=(const CpuLatency&) = delete;

    /// False if the system does not support or permit the request; see advice().
    bool isGranted() const { return granted_; }
    /// The reason if the request was refused, and how to permit it; empty if granted.
    static QString advice();

private:
    bool granted_;
};

}  // namespace tiller::realtime
