// SPDX-License-Identifier: MIT
#pragma once

// Digital outputs that are switched for a time measured by the robot: they are switched back even
// if this process crashes, hangs or loses the connection. The control program measures the time, so a pulse
// requires control. A secondary program could not measure it, because it must not take any time.

#include <chrono>
#include <cstdint>

#include "robot/control/controller.h"

namespace tiller::control {

inline constexpr int kPulseOutputs = 18;  ///< 0 ... 7 standard, 8 ... 15 configurable, 16 and 17 tool
inline constexpr std::chrono::hours kMaxPulse{1};

/// A pulse ends after its time, by end(), at the end of the control program (also by Controller::release()),
/// and if it is Held after 100 ms without a heartbeat of this computer. The control program itself ends after
/// 5 s without a heartbeat, which also ends Free pulses. Paths, functions and scripts need another control
/// program: they start when no output is pulsing, or fail with Timeout. A program that is killed or paused by
/// others (pendant, protective stop) cannot end its pulses.
///
/// Errors   of every call: NotInControl, LinkLost, Timeout, Cancelled, InvalidArgument, LimitExceeded
/// Threads  any. Blocks: until confirmed by the control program, typically 6 ms, at most until the deadline
class OutputPulses {
public:
    explicit OutputPulses(Controller& controller) : controller_(&controller) {}

    /// Sets the outputs selected by `mask` to the bits of `values`, and inverts them at the end of the time.
    /// Restarts outputs that are already pulsing.
    /// duration  above 0, at most kMaxPulse; rounded to the control period by the robot
    /// holding   Held: ends with the heartbeat of this computer
    Result<void> begin(std::uint32_t mask, std::uint32_t values, std::chrono::milliseconds duration,
                       Holding holding, const Deadline& deadline);
    /// Ends the pulses of these outputs now; outputs in the mask that are not pulsing are unchanged.
    Result<void> end(std::uint32_t mask, const Deadline& deadline);

private:
    Controller* controller_;
};

}  // namespace tiller::control
