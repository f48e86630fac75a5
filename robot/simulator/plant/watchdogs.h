// SPDX-License-Identifier: MIT
#pragma once

// rtde_set_watchdog(): pauses or stops the program if a client no longer refreshes an input. Source: URScript
// manual.

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "robot/simulator/urscript/host.h"

namespace tiller::simulator {

class Watchdogs {
public:
    /// Errors  FieldUnknown; InvalidArgument if the frequency is not above zero
    Result<void> set(std::string_view field, double minFrequency, urscript::WatchdogAction action);
    void clear() { dogs_.clear(); }

    /// Call when a data package with this input has been received. `input` is an index into
    /// rtde::inputFields().
    void touched(std::size_t input);

    /// Returns the due action, if any. A watchdog that has triggered is removed.
    std::optional<urscript::WatchdogAction> step(double dt);

private:
    struct Watchdog {
        std::size_t input = 0;
        double limit = 0;  ///< [s]
        double age = 0;    ///< [s]
        urscript::WatchdogAction action{};
    };
    std::vector<Watchdog> dogs_;
};

}  // namespace tiller::simulator
