// SPDX-License-Identifier: MIT
#include "robot/control/abandoned_program.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "robot/control/detail/control_script.h"
#include "robot/control/detail/registers.h"
#include "robot/rtde/fields.h"

namespace tiller::control {

namespace {

// Lower limit of ABANDONED in control.script [s].
constexpr double kAbandonedAfter = std::chrono::duration<double>(kMinAbandonedAfter).count();
// Time for which the value must increase with robot time [s]. A constant value is detected within half of
// this time.
constexpr double kProofTime = 0.05;
// On a CB3, the value is written up to two control periods late, and a script may run slightly slower than
// the clock.
constexpr double kDelay = 0.02;
constexpr double kDrift = 0.1;

/// True if a value that increased by `growth` [s] follows the robot time.
bool follows(double growth, double passed) {
    return std::abs(growth - passed) <= kDelay + kDrift * passed;
}

}  // namespace

std::array<std::string, 2> AbandonedProgram::fields() {
    const auto name = [](RegisterRange range) {
        return rtde::intRegisterName(rtde::Direction::Output, firstRegister(range) + kStateRegister);
    };
    return {name(RegisterRange::Lower), name(RegisterRange::Upper)};
}

void AbandonedProgram::add(double timestamp, RuntimeState runtime, const std::array<double, 2>& states) {
    for (std::size_t i = 0; i < states.size(); ++i) {
        const double value = -states[i] / 1000.0;
        Count& count = counts_[i];
        const bool isAbandoned = runtime == RuntimeState::Playing && value >= kAbandonedAfter;
        const double passed = timestamp - count.compared;
        // Allow for the delay once, not in every comparison.
        const bool grows = count.active && timestamp >= count.newest &&
                           follows(value - count.value, passed) &&
                           follows(value - count.first, timestamp - count.since);
        if (!isAbandoned) {
            count = {};
        } else if (!grows) {
            count = {true, timestamp, timestamp, timestamp, value, value};
        } else {
            count.newest = timestamp;
            if (passed >= kProofTime) {
                count.compared = timestamp;
                count.value = value;
            }
        }
    }
}

bool AbandonedProgram::isRunning() const {
    return std::any_of(counts_.begin(), counts_.end(), [](const Count& count) {
        return count.active && count.newest - count.since >= kProofTime;
    });
}

}  // namespace tiller::control
