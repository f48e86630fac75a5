// SPDX-License-Identifier: MIT
#include "robot/simulator/plant/watchdogs.h"

#include <algorithm>
#include <string>

#include "robot/rtde/fields.h"

namespace tiller::simulator {

Result<void> Watchdogs::set(std::string_view field, double minFrequency, urscript::WatchdogAction action) {
    const rtde::Field* found = rtde::findInput(field);
    if (found == nullptr) {
        return urscript::scriptError("rtde_set_watchdog: unknown RTDE input: " + std::string(field));
    }
    if (!(minFrequency > 0)) {
        return urscript::scriptError("rtde_set_watchdog: the frequency must be greater than 0");
    }
    const auto input = static_cast<std::size_t>(found - rtde::inputFields().data());
    std::erase_if(dogs_, [input](const Watchdog& dog) { return dog.input == input; });
    dogs_.push_back({input, 1.0 / minFrequency, 0, action});
    return {};
}

void Watchdogs::touched(std::size_t input) {
    for (Watchdog& dog : dogs_) {
        if (dog.input == input) {
            dog.age = 0;
        }
    }
}

std::optional<urscript::WatchdogAction> Watchdogs::step(double dt) {
    std::optional<urscript::WatchdogAction> action;
    for (Watchdog& dog : dogs_) {
        dog.age += dt;
        // A package may arrive at any time within a period, so one period is added to the limit.
        if (dog.age > dog.limit + dt && !action) {
            action = dog.action;
            dog.limit = 0;
        }
    }
    std::erase_if(dogs_, [](const Watchdog& dog) { return dog.limit == 0; });
    return action;
}

}  // namespace tiller::simulator
