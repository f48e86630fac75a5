// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Waits for the termination of a program without a window: Ctrl-C, or a request of the system.

#include <chrono>

namespace tiller::app {

/// Call before starting any thread, so that the signals are delivered here.
void holdTerminationSignals();

/// Blocks: at most for the given time. Returns  whether a termination was requested
bool waitForTermination(std::chrono::milliseconds atMost);

/// Blocks: until SIGINT or SIGTERM (on Windows: a console event), counted from holdTerminationSignals().
void waitForTermination();

}  // namespace tiller::app
