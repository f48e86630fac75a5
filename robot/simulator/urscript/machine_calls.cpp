// SPDX-License-Identifier: MIT
// Calls: frames on the stack of a script thread, and builtins, which may take several controller frames.

#include <algorithm>

#include "robot/simulator/urscript/machine.h"

namespace tiller::simulator::urscript {

void Interpreter::Machine::enter(Thread& thread, int function, int arguments) {
    const FunctionCode& f = code_.functions[static_cast<std::size_t>(function)];
    if (static_cast<int>(thread.calls.size()) >= limits_.callDepth) {
        fault("Too many nested function calls");
    }
    const std::size_t base = thread.top - static_cast<std::size_t>(arguments);
    thread.top = base + static_cast<std::size_t>(f.locals);
    const std::size_t needed = thread.top + static_cast<std::size_t>(f.stack) + 1;
    if (thread.stack.size() < needed) {
        thread.stack.resize(std::max(needed, thread.stack.size() * 2));
    }
    // Everything above the top is Unset, so the other locals are already.
    thread.calls.push_back({&f, 0, base});
}

// Back to the caller with the result; false when the thread has returned from its outermost function.
bool Interpreter::Machine::leave(Thread& thread, Value result) {
    const CallFrame done = thread.calls.back();
    for (std::size_t i = done.base; i < thread.top; ++i) {
        thread.stack[i].reset();
    }
    thread.top = done.base;
    if (thread.calls.size() == 1) {
        if (thread.id == 0) {
            state = State::Finished;
            over_ = true;
        }
        endThread(thread);
        return false;
    }
    thread.calls.pop_back();
    thread.stack[thread.top++] = std::move(result);
    return true;
}

// True: go on; false: the thread waits, or its slice is used up.
bool Interpreter::Machine::callBuiltin(Thread& thread, const Instruction& instruction) {
    const Builtin& builtin = builtins()[static_cast<std::size_t>(instruction.b)];
    const std::size_t first = thread.top - instruction.a;
    Call call(context_, builtin, thread.id, std::span(thread.stack.data() + first, instruction.a));
    if (thread.again) {
        call.first = false;
        call.state = thread.builtinState;
        call.waitedNs = (frame - thread.builtinSince) * context_.stepNs;
    }
    const Status status = builtin.function(call);
    thread.operations -= 8 + call.cost;
    const bool secondary = program->kind() == ProgramKind::Secondary;
    if (secondary && (status == Status::Again || call.consumedNs > 0 || call.endFrame)) {
        fault(kTooMuchBehind);
    }
    if (status == Status::Again) {
        if (!thread.again) {
            thread.again = true;
            thread.builtinSince = frame;
        }
        thread.builtinState = call.state;
        thread.state = Thread::State::Polling;
        --thread.calls.back().pc;
        return false;
    }
    thread.again = false;
    for (std::size_t i = first; i < thread.top; ++i) {
        thread.stack[i].reset();
    }
    thread.stack[first] = std::move(call.result);
    thread.top = first + 1;
    thread.sliceNs -= call.consumedNs;
    if (call.endFrame) {
        thread.sliceNs = std::min<std::int64_t>(thread.sliceNs, 0);
    }
    return thread.sliceNs > 0 && !stopRequested_;
}

}  // namespace tiller::simulator::urscript
