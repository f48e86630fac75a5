// SPDX-License-Identifier: MIT
#pragma once

// Sets digital outputs for a time that the robot measures. The outputs are reset even if this process
// crashes, hangs or loses the connection. The control program measures the time, so a pulse requires control.
// A secondary program cannot measure the time, because it must not take time itself.

#include <chrono>
#include <cstdint>

#include "robot/control/controller.h"

namespace tiller::control {

inline constexpr int kPulseOutputs = 18;  ///< 0 ... 7 standard, 8 ... 15 configurable, 16 and 17 tool
inline constexpr std::chrono::hours kMaxPulse{1};

/// A pulse ends after its duration, with end(), or when the control program ends (e.g. with
/// Controller::release()). A Held pulse also ends after 100 ms without a heartbeat of this PC. After 5 s
/// without a heartbeat, the control program ends, which also ends Free pulses. Paths, functions and scripts
/// replace the control program, so they start only when no output is pulsing, or fail with Timeout. A program
/// that is killed or paused from outside (pendant, protective stop) cannot end its pulses.
///
/// Errors   of every call: NotInControl, LinkLost, Timeout, Cancelled, InvalidArgument, LimitExceeded
/// Threads  any. Blocks: until confirmed by the control program, typically 6 ms, at most until the deadline
class OutputPulses {
public:
    explicit OutputPulses(Controller& controller) : controller_(&controller) {}

    /// Sets the outputs selected by `mask` to the bits of `values`, and inverts them after the duration.
    /// Restarts outputs that are already pulsing.
    /// duration  above 0, at most kMaxPulse; the robot rounds it to the control period
    /// holding   Held: the pulse also ends when the heartbeat of this PC is missing
    Result<void> begin(std::uint32_t mask, std::uint32_t values, std::chrono::milliseconds duration,
                       Holding holding, const Deadline& deadline);
    /// Ends the pulses of the outputs in the mask. Outputs that are not pulsing are unchanged.
    Result<void> end(std::uint32_t mask, const Deadline& deadline);

private:
    Controller* controller_;
};

}  // namespace tiller::control
