// SPDX-License-Identifier: MIT
#pragma once

// An in-memory robot for any program, with limits low enough for a fuzzer.

#include "robot/simulator/urscript/interpreter.h"
#include "tests/unit/robot/simulator/urscript/fake_host.h"

namespace tiller::simulator::urscript {

inline Limits lowLimits() {
    Limits limits;
    limits.threadOperationsPerFrame = 5000;
    limits.frameOperations = 20000;
    limits.callDepth = 50;
    limits.threads = 8;
    limits.listLength = 500;
    return limits;
}

/// Moves take two frames, and popups are answered immediately.
inline void hurry(FakeHost& host) {
    host.moveFrames = 2;
    host.popupAnswered = true;
}

/// Discards the recorded results of a frame, which would otherwise grow without limit.
inline void forget(FakeHost& host) {
    host.messages.clear();
    host.motions.clear();
    host.calls.clear();
    host.popups.clear();
}

}  // namespace tiller::simulator::urscript
