// SPDX-License-Identifier: MIT
#include "tests/benchmarks/machine_watch.h"

#include <algorithm>
#include <chrono>

#include "robot/realtime/periodic_timer.h"
#include "robot/realtime/realtime_report.h"

namespace tiller::benchmark {

namespace {

constexpr int kAboveAll = 99;
// No shorter period: on a virtual machine, each wake-up takes time of the hypervisor, and the watch itself
// would cause disturbances. The period is not a fraction of a control period, which would always sample the
// same phase.
constexpr auto kPeriod = std::chrono::microseconds(263);
constexpr std::int64_t kMaxNs = 350'000;  ///< maximum interval between wake-ups on an available CPU
constexpr std::size_t kMaxValue = 1'000'000;

std::int64_t nowNs() {
    return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

MachineWatch::MachineWatch() {
    const int count = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    for (int i = 0; i < count; ++i) {
        Processor& processor = *processors_.emplace_back(std::make_unique<Processor>());
        processor.absences.resize(kMaxValue);
        processor.thread = std::thread([this, &processor, i] { watch(processor, i); });
        // Staggered, so that a thread disturbed on one CPU can use another CPU.
        std::this_thread::sleep_for(kPeriod / count);
    }
}

MachineWatch::~MachineWatch() {
    over_ = true;
    for (const auto& processor : processors_) {
        processor->thread.join();
    }
}

void MachineWatch::watch(Processor& processor, int number) {
    realtime::nameThread("machine watch");
    processor.granted =
        realtime::bindToCpus({number}).isEmpty() && realtime::requestThreadPriority(kAboveAll).ok();
    realtime::PeriodicTimer timer(kPeriod);
    std::int64_t woke = nowNs();
    while (!over_) {
        timer.wait();
        const std::int64_t now = nowNs();
        const std::size_t next = processor.count;
        if (now - woke > kMaxNs && next < processor.absences.size()) {
            processor.absences[next] = {woke, now};
            processor.count = next + 1;
        }
        woke = now;
    }
}

bool MachineWatch::isWatching() const {
    return std::all_of(processors_.begin(), processors_.end(), [](const auto& processor) {
        return processor->granted && processor->count < kMaxValue;
    });
}

bool MachineWatch::wasAway(std::int64_t fromNs, std::int64_t toNs) const {
    for (const auto& processor : processors_) {
        const auto begin = processor->absences.begin();
        const auto end = begin + static_cast<std::ptrdiff_t>(processor->count.load());
        const auto first =
            std::lower_bound(begin, end, fromNs,
                             [](const Absence& absence, std::int64_t time) { return absence.toNs < time; });
        if (first != end && first->fromNs <= toNs) {
            return true;
        }
    }
    return false;
}

std::uint64_t MachineWatch::count() const {
    std::uint64_t count = 0;
    for (const auto& processor : processors_) {
        count += processor->count;
    }
    return count;
}

double MachineWatch::seconds() const {
    std::int64_t sum = 0;
    for (const auto& processor : processors_) {
        for (std::size_t i = 0; i < processor->count; ++i) {
            sum += processor->absences[i].toNs - processor->absences[i].fromNs;
        }
    }
    return static_cast<double>(sum) / 1e9;
}

}  // namespace tiller::benchmark
