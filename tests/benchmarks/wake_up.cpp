// SPDX-License-Identifier: MIT
// Measures the accuracy and cost of the wake-ups of three 2 ms loops: one that only busy-waits, one that
// only sleeps, and Tiller's loop, which busy-waits for the measured wake-up delay. The loops alternate,
// so that load on the computer affects all of them.
//
//     wake_up [seconds per loop and round, 3 by default] [rounds, 3 by default] [priority, 0 by default]
//
// The first run is without load. In the second run, threads of the normal scheduler keep all CPUs but one
// busy. A wake-up more than 2.5 ms after the previous one is late. Target: no more late wake-ups than the
// busy-waiting loop at less than half its cost.

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

#include "robot/platform/thread_priority.h"
#include "robot/realtime/cpu_latency.h"
#include "robot/realtime/histogram.h"
#include "robot/realtime/periodic_timer.h"

using namespace tiller;
using namespace tiller::realtime;

namespace {

constexpr std::int64_t kPeriodNs = 2 * kNsPerMs;
constexpr std::int64_t kLateNs = 2'500'000;

enum class Kind { Spins, Sleeps, Punctual };
constexpr const char* kNames[] = {"spins", "sleeps", "Tiller"};

struct Figures {
    Histogram cycles;
    double processorSeconds = 0;
    double seconds = 0;
};

/// Runs a loop in a separate thread and adds its results.
void runLoop(Kind kind, double seconds, int priority, Figures& figures) {
    std::thread([&] {
        (void)requestThreadPriority(priority);
        const SteadyClock& clock = SteadyClock::shared();
        PeriodicTimer timer{std::chrono::nanoseconds(kPeriodNs), kind == Kind::Punctual};
        const std::int64_t begin = clock.nowNs();
        const double cost = threadSeconds();
        std::int64_t before = begin;
        std::int64_t due = begin;
        while (before - begin < static_cast<std::int64_t>(seconds * 1e9)) {
            if (kind == Kind::Spins) {
                due += kPeriodNs;
                while (clock.nowNs() < due) {
                }
            } else {
                timer.wait();
            }
            const std::int64_t now = clock.nowNs();
            if (before != begin) {
                figures.cycles.add(now - before);
            }
            before = now;
        }
        figures.processorSeconds += threadSeconds() - cost;
        figures.seconds += static_cast<double>(before - begin) * 1e-9;
    }).join();
}

/// Threads of the normal scheduler that are permanently busy.
class Load {
public:
    explicit Load(unsigned threads) {
        for (unsigned i = 0; i < threads; ++i) {
            threads_.emplace_back([this] {
                std::uint64_t work = i_;
                while (!over_.load(std::memory_order_relaxed)) {
                    work = work * 6364136223846793005U + 1442695040888963407U;
                }
                i_.store(work, std::memory_order_relaxed);
            });
        }
    }
    ~Load() {
        over_ = true;
        for (std::thread& thread : threads_) {
            thread.join();
        }
    }
    Load(const Load&) = delete;
    Load& operator=(const Load&) = delete;

private:
    std::atomic<bool> over_{false};
    std::atomic<std::uint64_t> i_{1};
    std::vector<std::thread> threads_;
};

void measure(const char* title, unsigned load, double seconds, int rounds, int priority) {
    Figures figures[3];
    {
        const Load busy(load);
        for (int round = 0; round < rounds; ++round) {
            for (const Kind kind : {Kind::Spins, Kind::Sleeps, Kind::Punctual}) {
                runLoop(kind, seconds, priority, figures[static_cast<int>(kind)]);
            }
        }
    }
    std::printf("\n%s\n%-8s %9s %9s %9s %9s %9s %9s\n", title, "loop", "cycles", "late", "p50 ms", "p99 ms",
                "p99.9 ms", "% of CPU");
    for (int i = 0; i < 3; ++i) {
        const Histogram& cycles = figures[i].cycles;
        std::printf("%-8s %9llu %9llu %9.3f %9.3f %9.3f %9.1f\n", kNames[i],
                    static_cast<unsigned long long>(cycles.count()),
                    static_cast<unsigned long long>(cycles.countAbove(kLateNs)),
                    static_cast<double>(cycles.percentileNs(50)) * 1e-6,
                    static_cast<double>(cycles.percentileNs(99)) * 1e-6,
                    static_cast<double>(cycles.percentileNs(99.9)) * 1e-6,
                    100 * figures[i].processorSeconds / figures[i].seconds);
    }
}

}  // namespace

int main(int argc, char* argv[]) {
    const double seconds = argc > 1 ? std::atof(argv[1]) : 3;
    const int rounds = argc > 2 ? std::atoi(argv[2]) : 3;
    const int priority = argc > 3 ? std::atoi(argv[3]) : 0;
    if (!(seconds > 0) || rounds < 1 || priority < 0 || priority > 99) {
        std::fprintf(stderr, "wake_up [seconds] [rounds] [priority 0 to 99]\n");
        return 2;
    }
    const unsigned processors = std::thread::hardware_concurrency();
    {
        const CpuLatency latency;
        std::printf("%u processors, %d rounds of %g s a loop, priority %d, fast wake-ups %s\n", processors,
                    rounds, seconds, priority, latency.isGranted() ? "granted" : "not granted");
        measure("the machine as it is", 0, seconds, rounds, priority);
        measure("all processors but one busy", processors > 1 ? processors - 1 : 1, seconds, rounds,
                priority);
    }
    return 0;
}
