// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Waiting for the moment somebody ends a program that has no window: Ctrl-C, or a request of the system.

#include <chrono>

namespace tiller::app {

/// Call before any thread is started, so that none of them is interrupted.
void holdTerminationSignals();

/// Blocks: so long, or until it comes. Returns  whether it came
bool waitForTermination(std::chrono::milliseconds atMost);

/// Blocks: until SIGINT or SIGTERM (on Windows: a console event) comes. One that came since
/// holdTerminationSignals() counts.
void waitForTermination();

}  // namespace tiller::app
