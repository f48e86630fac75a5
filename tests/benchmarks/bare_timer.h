// SPDX-License-Identifier: MIT
#pragma once

// A thread that only wakes up every 2 ms, as a reference for the measured code. Its priority is the same or
// higher. Its delays are the minimum that any program can reach on this computer.

#include <atomic>
#include <chrono>
#include <thread>

#include "robot/platform/thread_priority.h"
#include "robot/realtime/histogram.h"
#include "robot/realtime/periodic_timer.h"

namespace tiller::benchmark {

/// Runs one thread from construction until stop().
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
