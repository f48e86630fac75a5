// SPDX-License-Identifier: MIT
#pragma once

// Tells what the machine did from what the program did. On each processor a thread above every priority that
// is measured does nothing but wake up: when even that comes late, the processor was not there (a hypervisor
// took it, or the kernel did not let go of it), and no program on it could have been in time.

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

namespace tiller::benchmark {

/// Needs SCHED_FIFO (root, or a line in limits.d) to be worth anything: see isWatching().
/// Threads  one that asks, after stop() or while it runs
class MachineWatch {
public:
    MachineWatch();
    ~MachineWatch();
    MachineWatch(const MachineWatch&) = delete;
    MachineWatch& operator=(const MachineWatch&) = delete;

    bool isWatching() const;
    /// Whether a processor was away between these times of the steady clock [ns].
    bool wasAway(std::int64_t fromNs, std::int64_t toNs) const;
    /// How often, and for how long in all [s], processors were away.
    std::uint64_t count() const;
    double seconds() const;

private:
    struct Absence {
        std::int64_t fromNs;
        std::int64_t toNs;
    };
    /// Filled by its thread alone; `count` says how many are complete.
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
