// SPDX-License-Identifier: MIT
#pragma once

// A thread that does nothing but wake up every 2 ms. Put beside what is measured, at its priority or above:
// what this finds, any program on the machine finds.

#include <atomic>
#include <chrono>
#include <thread>

#include "robot/realtime/histogram.h"
#include "robot/realtime/periodic_timer.h"
#include "robot/realtime/thread_priority.h"

namespace tiller::benchmark {

/// Threads  one of its own, from construction to stop()
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
    /// After stop(): how late it woke, and the times from one waking to the next [ns].
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
