// SPDX-License-Identifier: MIT
#pragma once

// A thread that only wakes up every 2 ms, as a reference next to the measured code, with the same or a higher
// priority: any program on this machine has at least its delays.

#include <atomic>
#include <chrono>
#include <thread>

#include "robot/realtime/histogram.h"
#include "robot/realtime/periodic_timer.h"
#include "robot/realtime/thread_priority.h"

namespace tiller::benchmark {

/// Threads: one, from construction to stop().
class BareTimer {
public:
    explicit BareTimer(int priority) : thread_([this, priority] { run(priority); }) {}
    ~BareTimer() { stop(); }
    BareTimer(const BareTimer&) = delete;
    BareTimer& operator=(const BareTimer&) = delete;

    void stop() {
        over_ = true;
        if (thread_.joinable()) {
            thread_.join();
        }
    }
    /// Available after stop(): delays and intervals of the wake-ups [ns].
    const realtime::Histogram& lateness() const { return lateness_; }
    const realtime::Histogram& cycles() const { return cycles_; }

private:
    void run(int priority) {
        (void)realtime::requestThreadPriority(priority);
        realtime::PeriodicTimer timer(std::chrono::milliseconds(2));
        auto previous = std::chrono::steady_clock::now();
        while (!over_) {
            timer.wait();
            const auto now = std::chrono::steady_clock::now();
            lateness_.add(timer.latenessNs());
            cycles_.add(std::chrono::nanoseconds(now - previous).count());
            previous = now;
        }
    }

    std::atomic<bool> over_{false};
    realtime::Histogram lateness_;
    realtime::Histogram cycles_;
    std::thread thread_;
};

}  // namespace tiller::benchmark
