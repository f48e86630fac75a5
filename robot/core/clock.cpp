// SPDX-License-Identifier: MIT
#include "robot/core/clock.h"

#include "robot/platform/sleep.h"

namespace tiller {

void SteadyClock::sleepUntil(std::int64_t ns) {
    sleepUntilNs(ns);
}

void SteadyClock::waitUntil(std::int64_t ns, std::int64_t awakeNs) const {
    if (ns - nowNs() > awakeNs) {
        sleepUntil(ns - awakeNs);
    }
    while (nowNs() < ns) {
    }
}

}  // namespace tiller
