// SPDX-License-Identifier: MIT
#pragma once

// A robot made of memory for any program, with bounds so low that a fuzzer comes to them.

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

/// Moves take two frames, popups are answered at once.
inline void hurry(FakeHost& host) {
    host.moveFrames = 2;
    host.popupAnswered = true;
}

/// What a frame left is forgotten: it would grow without bound.
inline void forget(FakeHost& host) {
    host.messages.clear();
    host.motions.clear();
    host.calls.clear();
    host.popups.clear();
}

}  // namespace tiller::simulator::urscript
