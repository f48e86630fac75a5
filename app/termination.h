// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Waits for the termination of a program without a window, by Ctrl+C or a request of the system.

#include <chrono>

namespace tiller::app {

/// Call this before any thread is started, so that the signals are delivered here.
void holdTerminationSignals();

/// Blocks: at most for the given time. Returns true if termination was requested.
bool waitForTermination(std::chrono::milliseconds atMost);

/// Blocks: until SIGINT or SIGTERM (on Windows: a console event) since the call of holdTerminationSignals().
void waitForTermination();

}  // namespace tiller::app
