// SPDX-License-Identifier: MIT
#pragma once

// Implementation of Interpreter: the scheduler for the script threads, and the life cycle of the program.

#include <memory>
#include <optional>
#include <vector>

#include "robot/simulator/urscript/execution.h"
#include "robot/simulator/urscript/interpreter.h"

namespace tiller::simulator::urscript {

class Interpreter::Machine final : private Execution {
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

    std::int64_t frame() const { return frame_; }
    int currentLine() const;
    int threadCount() const;
    const Value* global(std::string_view name) const;
    InterpreterMode& mode() { return mode_; }

private:
    // Requests of threads, see Execution.
    ThreadId startThread(int function, ThreadId parent) override;
    bool isAlive(ThreadId id) const override { return find(id) != nullptr; }
    ThreadId handleOf(const Value& v) const override;
    void endThread(ScriptThread& thread) override;
    void killTree(ThreadId id) override;
    void forgetLines() override;
    void finish() override;
    void requestPause() override { pauseRequested_ = true; }
    bool isStopRequested() const override { return stopRequested_; }

    void beginFrame();
    void pollMotion();
    void abortMove();
    bool runnable(const ScriptThread& thread) const;
    ScriptThread* next() const;
    void run(ScriptThread& thread);
    void removeEnded();
    ScriptThread& start(int function, ThreadId parent);
    ScriptThread* find(ThreadId id) const;
    void finishProgram();
    void fail(const ScriptThread& thread, const std::string& text);
    static ast::Position position(const ScriptThread& thread);

    std::vector<std::unique_ptr<ScriptThread>> threads_;
    ThreadId nextId_ = 0;
    bool inFrame_ = false;
    bool pauseRequested_ = false;
    bool stopRequested_ = false;
    bool over_ = false;  // skips the rest of the frame
    bool hostNotified_ = true;
};

}  // namespace tiller::simulator::urscript
