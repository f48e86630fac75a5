// SPDX-License-Identifier: MIT
#pragma once

// A thread that only wakes up every 2 ms, as a reference for the measured code. It has the same priority or a
// higher one. Any program on this computer has at least the delays of this thread.

#include <atomic>
#include <chrono>
#include <thread>

#include "robot/platform/thread_priority.h"
#include "robot/realtime/histogram.h"
#include "robot/realtime/periodic_timer.h"

namespace tiller::benchmark {

/// Threads: one, from construction until stop().
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
    /// Delays and intervals of the wake-ups [ns]. Available after stop().
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
