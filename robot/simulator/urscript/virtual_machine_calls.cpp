// SPDX-License-Identifier: MIT
// Calls: frames on the stack of a script thread, and builtins, which may take several controller frames.

#include <algorithm>

#include "robot/simulator/urscript/virtual_machine.h"

namespace tiller::simulator::urscript {

void Interpreter::Machine::enter(Thread& thread, int function, int arguments) {
    push(thread, code_.functions[static_cast<std::size_t>(function)], arguments);
}

void Interpreter::Machine::push(Thread& thread, const LinkedCode::Callee& callee, int arguments) {
    const FunctionCode& f = *callee.function;
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
    thread.calls.push_back({&f, callee.unit, 0, base});
}

// The next line of interpreter mode, called from where its builtin stands.
void Interpreter::Machine::enterLine(Thread& thread) {
    const Unit& unit = mode_.begin();
    globals_.resize(std::max(globals_.size(), code_.globals.size()));
    push(thread, {&unit.code->functions.front(), &unit}, 0);
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
    if (done.unit->owned != nullptr && done.function == &done.unit->code->functions.front()) {
        mode_.lineDone();  // its result is nobody's
    } else {
        thread.stack[thread.top++] = std::move(result);
    }
    return true;
}

// Wait: it is to be executed again, or the slice is used up.
Interpreter::Machine::After Interpreter::Machine::callBuiltin(Thread& thread,
                                                              const Instruction& instruction) {
    const Builtin& builtin = builtins()[static_cast<std::size_t>(instruction.b)];
    const std::size_t first = thread.top - instruction.a;
    Call call(context_, builtin, thread.id, std::span(thread.stack.data() + first, instruction.a));
    if (thread.again) {
        call.first = false;
        call.state = thread.builtinState;
        call.waitedNs = (frame - thread.builtinSince) * context_.stepNs;
    }
    const Status status = builtin.function(call);
    if (mode_.takeForget()) {
        forgetLines();
    }
    thread.operations -= 8 + call.cost;
    // However much a client sends, and however often the program asks for more: reading takes time.
    call.endFrame =
        call.endFrame || (call.readSocket && limits_.threadOperationsPerFrame - thread.operations >=
                                                 limits_.readingOperationsPerFrame);
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
        return After::Wait;
    }
    thread.again = false;
    if (status == Status::Line) {
        --thread.calls.back().pc;
        enterLine(thread);
        return After::Reload;
    }
    for (std::size_t i = first; i < thread.top; ++i) {
        thread.stack[i].reset();
    }
    thread.stack[first] = std::move(call.result);
    thread.top = first + 1;
    thread.sliceNs -= call.consumedNs;
    if (call.endFrame) {
        thread.sliceNs = std::min<std::int64_t>(thread.sliceNs, 0);
    }
    // Whoever has used some of its time lets those go first who have more left.
    return thread.sliceNs > 0 && call.consumedNs == 0 && !stopRequested_ ? After::GoOn : After::Wait;
}

}  // namespace tiller::simulator::urscript
