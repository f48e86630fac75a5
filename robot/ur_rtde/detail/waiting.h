// SPDX-License-Identifier: MIT
#pragma once

// How the calls of this room wait: with a deadline, and ended early where the host program says that its user
// lost patience (Python on Ctrl-C). Private to this room and robot/python.

#include <chrono>
#include <stdexcept>

#include "robot/core/deadline.h"
#include "robot/core/error.h"

namespace tiller::urrtde {

/// Thrown by a call that waited when the host's check said so.
class Interrupted : public std::runtime_error {
public:
    Interrupted() : std::runtime_error("interrupted") {}
};

/// check  asked about every 10 ms in the thread that waits; null: never
void setInterruptCheck(bool (*check)());
/// Asks the check, at most every 10 ms of real time.
bool isInterrupted();
void throwIfInterrupted();

/// While one lives, its thread is not interrupted: what an interruption makes necessary, a stop above all, is
/// done even when the user loses patience twice.
class Uninterrupted {
public:
    Uninterrupted();
    ~Uninterrupted();
    Uninterrupted(const Uninterrupted&) = delete;
    Uninterrupted& operator=(const Uninterrupted&) = delete;
};

Deadline within(std::chrono::milliseconds time);
/// Sleeps, in slices, until then.
void sleepUntil(std::chrono::steady_clock::time_point end);

/// std::runtime_error with the error's text; Interrupted when that is why.
[[noreturn]] void raise(const Error& error);

}  // namespace tiller::urrtde
