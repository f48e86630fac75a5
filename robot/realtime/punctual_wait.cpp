// SPDX-License-Identifier: MIT
#include "robot/realtime/punctual_wait.h"

#include <algorithm>

namespace tiller::realtime {
namespace {

constexpr std::int64_t kMinAwakeNs = 5'000;
// A late wake-up raises the bound by 99 times the decrease for a timely one, so that it converges to the 99th
// percentile.
constexpr std::int64_t kDownNs = 200;
constexpr std::int64_t kUpNs = 99 * kDownNs;
constexpr int kWhole = 65'536;
constexpr int kMemory = 64;  // averaging length in wake-ups

}  // namespace

std::int64_t PunctualWait::awakeNs() const {
    return maySpin_ && hopeless_ < kWhole / 2 ? awakeNs_ : 0;
}

void PunctualWait::learn(std::int64_t lateNs) {
    awakeNs_ = std::clamp(awakeNs_ + (lateNs > awakeNs_ ? kUpNs : -kDownNs), kMinAwakeNs, kMaxAwakeNs);
    hopeless_ += ((lateNs > kMaxAwakeNs ? kWhole : 0) - hopeless_) / kMemory;
}

void PunctualWait::until(const Clock& clock, std::int64_t ns) {
    const std::int64_t up = ns - awakeNs();
    if (clock.runsByItself() && clock.nowNs() < up) {
        clock.waitUntil(up, 0);
        learn(clock.nowNs() - up);
    }
    const std::int64_t from = clock.nowNs();
    if (from < ns) {
        clock.waitUntil(ns, ns - from);
        spentNs_ += clock.nowNs() - from;
    }
}

}  // namespace tiller::realtime
