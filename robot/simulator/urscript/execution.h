// SPDX-License-Identifier: MIT
#pragma once

// Executes the bytecode of a script thread within its time slice, until the thread waits, ends or fails. The
// scheduler (virtual_machine.h) assigns the slices.

#include <cstdint>
#include <span>
#include <vector>

#include "robot/simulator/urscript/bytecode.h"
#include "robot/simulator/urscript/call.h"
#include "robot/simulator/urscript/interpreter.h"
#include "robot/simulator/urscript/interpreter_mode.h"
#include "robot/simulator/urscript/linked_code.h"
#include "robot/simulator/urscript/remote_calls.h"
#include "robot/simulator/urscript/script_thread.h"

namespace tiller::simulator::urscript {

class Execution {
protected:
    Execution(const Program& program, Host& host, const Limits& limits);
    ~Execution() = default;

    void execute(ScriptThread& thread);
    /// Pushes a call of the function onto the thread's stack.
    void enter(ScriptThread& thread, int function, int arguments);

    Host& host_;
    const Limits limits_;
    LinkedCode code_;
    InterpreterMode mode_;
    RemoteCalls remote_;
    CallContext context_;
    std::vector<Value> globals_;
    std::int64_t frame_ = 0;
    std::int64_t frameOperations_ = 0;  ///< remaining operations for all threads

private:
    // Requests from a thread to the scheduler.
    /// Throws a fault if there are too many threads.
    virtual ThreadId startThread(int function, ThreadId parent) = 0;
    virtual bool isAlive(ThreadId id) const = 0;
    /// Returns the thread for a handle; -1: none.
    virtual ThreadId handleOf(const Value& v) const = 0;
    virtual void endThread(ScriptThread& thread) = 0;
    virtual void killTree(ThreadId id) = 0;
    /// Discards the interpreter mode lines and ends the threads that run in them.
    virtual void forgetLines() = 0;
    virtual void finish() = 0;
    virtual void requestPause() = 0;
    virtual bool isStopRequested() const = 0;

    // calls
    bool leave(ScriptThread& thread, Value result);
    void enterLine(ScriptThread& thread);
    void push(ScriptThread& thread, const LinkedCode::Callee& callee, int arguments);
    enum class After { GoOn, Reload, Wait };
    After callBuiltin(ScriptThread& thread, const Instruction& instruction);
    bool callMethod(ScriptThread& thread, const MethodCall& call);
    bool callRemote(ScriptThread& thread, std::int32_t handle, const MethodCall& call,
                    std::span<const Value> arguments, Value& result);

    // variables
    [[noreturn]] void unset(const ScriptThread& thread, bool global, int slot) const;
    Value& variable(ScriptThread& thread, const Path& path);
    void storePath(ScriptThread& thread, const Path& path);
};

}  // namespace tiller::simulator::urscript
