// SPDX-License-Identifier: MIT
#pragma once

// Waiting functions of robot/ur_rtde, with a deadline and interruptible by the host program (Python on
// Ctrl+C). Private to robot/ur_rtde and robot/python.

#include <chrono>
#include <stdexcept>

#include "robot/core/deadline.h"
#include "robot/core/error.h"

namespace tiller::urrtde {

/// Thrown by a waiting call that the host's check has interrupted.
class Interrupted : public std::runtime_error {
public:
    Interrupted() : std::runtime_error("interrupted") {}
};

/// check  called about every 10 ms in the waiting thread; null: never
void setInterruptCheck(bool (*check)());
/// Calls the check at most once per 10 ms of real time.
bool isInterrupted();
void throwIfInterrupted();

/// Blocks interrupts of its thread during its lifetime, so that actions after an interrupt, in particular a
/// stop, are completed even if the user interrupts again.
class Uninterrupted {
public:
    Uninterrupted();
    ~Uninterrupted();
    Uninterrupted(const Uninterrupted&) = delete;
    Uninterrupted& operator=(const Uninterrupted&) = delete;
};

Deadline within(std::chrono::milliseconds time);
/// Sleeps until `end`, and calls the interrupt check every 50 ms.
void sleepUntil(std::chrono::steady_clock::time_point end);

/// Throws std::runtime_error with the text of the error, or Interrupted after an interrupt.
[[noreturn]] void raise(const Error& error);

}  // namespace tiller::urrtde
