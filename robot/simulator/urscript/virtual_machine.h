// SPDX-License-Identifier: MIT
#pragma once

// The inside of an Interpreter: script threads with their stacks, and the scheduler that shares out the
// frame.

#include <memory>
#include <vector>

#include "robot/simulator/urscript/builtin.h"
#include "robot/simulator/urscript/bytecode.h"
#include "robot/simulator/urscript/interpreter.h"
#include "robot/simulator/urscript/interpreter_mode.h"
#include "robot/simulator/urscript/linked_code.h"
#include "robot/simulator/urscript/remote_calls.h"

namespace tiller::simulator::urscript {

class Interpreter::Machine {
public:
    Machine(std::shared_ptr<const Program> program, Host& host, const Limits& limits);
    ~Machine();

    State runFrame();
    void pause();
    void resume();
    void stop();

    State state = State::Running;
    std::optional<RuntimeError> error;
    const std::shared_ptr<const Program> program;
    std::int64_t frame = 0;

    int currentLine() const;
    int threadCount() const;
    const Value* global(std::string_view name) const;
    InterpreterMode& mode() { return mode_; }

private:
    struct CallFrame {
        const FunctionCode* function = nullptr;
        const Unit* unit = nullptr;
        int pc = 0;            // next instruction
        std::size_t base = 0;  // first local on the stack
    };

    struct Thread {
        enum class State {
            Ready,
            Polling,  // inside a builtin that is executed again next frame
            Joining,
            Ended,
        };
        ThreadId id = 0;
        ThreadId parent = -1;
        State state = State::Ready;
        ThreadId joined = 0;
        std::int64_t sliceNs = 0;
        std::int64_t operations = 0;  // left in this frame
        std::vector<Value> stack;
        std::size_t top = 0;
        std::vector<CallFrame> calls;
        // of the builtin being executed over several frames
        bool again = false;
        std::int64_t builtinState = 0;
        std::int64_t builtinSince = 0;
    };

    // scheduling (machine.cpp)
    void beginFrame();
    void pollMotion();
    void abortMove();
    void forgetLines();
    bool runnable(const Thread& thread) const;
    Thread* next() const;
    void removeEnded();
    Thread& start(int function, ThreadId parent);
    Thread* find(ThreadId id) const;
    void endThread(Thread& thread);
    void killTree(ThreadId id);
    void finishProgram();
    void fail(const Thread& thread, const std::string& text);
    static ast::Position position(const Thread& thread);
    ThreadId handleOf(const Value& v) const;

    // execution (machine_run.cpp)
    void run(Thread& thread);
    void execute(Thread& thread);

    // calls (machine_calls.cpp)
    void enter(Thread& thread, int function, int arguments);
    bool leave(Thread& thread, Value result);
    void enterLine(Thread& thread);
    void push(Thread& thread, const LinkedCode::Callee& callee, int arguments);
    enum class After { GoOn, Reload, Wait };
    After callBuiltin(Thread& thread, const Instruction& instruction);

    // values in variables (machine_values.cpp)
    void store(Value& variable, Value v, const std::string& name) const;
    [[noreturn]] void unset(const Thread& thread, bool global, int slot) const;
    Value& variable(Thread& thread, const Path& path);
    Value& descend(Value& root, const Path& path, std::size_t steps, const Value*& indices) const;
    void storePath(Thread& thread, const Path& path);
    bool callMethod(Thread& thread, const MethodCall& call);
    // machine_remote.cpp
    bool callRemote(Thread& thread, std::int32_t handle, const MethodCall& call,
                    std::span<const Value> arguments, Value& result);
    Value applyMethod(Value& object, const MethodCall& call, const Value* arguments) const;
    void checkBounds(const Value& root) const;

    Host& host_;
    const Limits limits_;
    LinkedCode code_;
    InterpreterMode mode_;
    RemoteCalls remote_;
    CallContext context_;
    std::vector<Value> globals_;
    std::vector<std::unique_ptr<Thread>> threads_;
    ThreadId nextId_ = 0;
    std::int64_t frameOperations_ = 0;
    bool inFrame_ = false;
    bool pauseRequested_ = false;
    bool stopRequested_ = false;
    bool over_ = false;  // the rest of the frame is not to run
    bool hostTold_ = true;
};

}  // namespace tiller::simulator::urscript
