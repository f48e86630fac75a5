// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "robot/simulator/urscript/bytecode.h"
#include "robot/simulator/urscript/host.h"
#include "robot/simulator/urscript/linked_code.h"
#include "robot/simulator/urscript/value.h"

namespace tiller::simulator::urscript {

struct CallFrame {
    const FunctionCode* function = nullptr;
    const Unit* unit = nullptr;
    int pc = 0;            // next instruction
    std::size_t base = 0;  // first local on the stack
};

/// A thread of a script: its calls, its stack, and the state of a builtin that takes several frames.
struct ScriptThread {
    enum class State {
        Ready,
        Polling,  // in a builtin that is executed again in the next frame
        Joining,
        Ended,
    };
    ThreadId id = 0;
    ThreadId parent = -1;
    State state = State::Ready;
    ThreadId joined = 0;
    std::int64_t sliceNs = 0;
    std::int64_t operations = 0;  // remaining operations in this frame
    std::vector<Value> stack;
    std::size_t top = 0;
    std::vector<CallFrame> calls;
    // state of a builtin that takes several frames
    bool again = false;
    std::int64_t builtinState = 0;
    std::int64_t builtinSince = 0;
};

}  // namespace tiller::simulator::urscript
