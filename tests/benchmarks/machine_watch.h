// SPDX-License-Identifier: MIT
#pragma once

// Distinguishes delays of the computer from delays of the program. On each CPU, a thread with a priority
// above all measured threads only wakes up. If it is late, the CPU was not available (used by a hypervisor or
// the kernel), and no program on this CPU could have been in time.

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

namespace tiller::benchmark {

/// Requires SCHED_FIFO (root, or an entry in limits.d); see isWatching(). Threads: one caller, after stop()
/// or while the watch is running.
class MachineWatch {
public:
    MachineWatch();
    ~MachineWatch();
    MachineWatch(const MachineWatch&) = delete;
    MachineWatch& operator=(const MachineWatch&) = delete;

    bool isWatching() const;
    /// True if a CPU was unavailable between these times of the steady clock [ns].
    bool wasAway(std::int64_t fromNs, std::int64_t toNs) const;
    /// Number and total duration [s] of unavailable periods.
    std::uint64_t count() const;
    double seconds() const;

private:
    struct Absence {
        std::int64_t fromNs;
        std::int64_t toNs;
    };
    /// Written only by the thread of the CPU. `count` is the number of complete entries.
    struct Processor {
        std::vector<Absence> absences;
        std::atomic<std::size_t> count{0};
        std::atomic<bool> granted{false};
        std::thread thread;
    };
    void watch(Processor& processor, int number);

    std::atomic<bool> over_{false};
    std::vector<std::unique_ptr<Processor>> processors_;
};

}  // namespace tiller::benchmark
