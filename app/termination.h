// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Waits until Ctrl+C or the system requests the termination of a program without a window.

#include <chrono>

namespace tiller::app {

/// Blocks the termination signals (on Windows, handles console events). Call this before any thread is
/// started, so that all threads inherit the signal mask.
void holdTerminationSignals();

/// Blocks: at most for the given time. Returns true if termination was requested.
bool waitForTermination(std::chrono::milliseconds atMost);

/// Blocks: until SIGINT or SIGTERM (on Windows, a console event) has been received since
/// holdTerminationSignals().
void waitForTermination();

}  // namespace tiller::app
