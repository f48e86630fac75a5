// SPDX-License-Identifier: MIT
#pragma once

// Runs one program, one controller frame at a time. Within a frame every script thread runs until it blocks,
// ends or has used its time slice; between frames nothing runs. The order is deterministic: the thread with
// most of its slice left first, among equals the eldest; a thread started in a frame still runs in it.
//
// Host side protocol: each control period call runFrame() once, then step the arm. The destructor and stop()
// end the program and tell the host.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "robot/simulator/urscript/host.h"
#include "robot/simulator/urscript/program.h"
#include "robot/simulator/urscript/value.h"

namespace tiller::simulator::urscript {

/// What ended a program before its time. Line and column count from 1 in the compiled text.
struct RuntimeError {
    int line = 0;
    int column = 0;
    std::string text;
    bool overrun = false;  ///< a loop that took no time
};

struct Limits {
    std::int64_t threadOperationsPerFrame = 1'000'000;  ///< more is an infinite loop
    /// A thread that reads a socket after so many has used up its frame: however much there is to be read,
    /// reading it takes time.
    std::int64_t readingOperationsPerFrame = 100'000;
    std::int64_t frameOperations = 4'000'000;  ///< of all threads together
    int callDepth = 200;
    int threads = 128;
    std::size_t listLength = 100'000;
    std::uint64_t randomSeed = 1;
    bool threadsBeginNextFrame = false;     ///< otherwise in the one in which they are run
    bool remoteServersMayBeAbsent = false;  ///< rpc_factory() does not look whether its server accepts
};

class InterpreterMode;

class Interpreter {
public:
    enum class State {
        Running,
        Paused,
        Finished,  ///< main body ended, or `halt`
        Stopped,   ///< by stop()
        Failed,    ///< see error()
    };

    Interpreter(std::shared_ptr<const Program> program, Host& host, const Limits& limits = {});
    ~Interpreter();
    Interpreter(const Interpreter&) = delete;
    Interpreter& operator=(const Interpreter&) = delete;

    /// Advances the program by one frame of host().stepTime(). Does nothing unless running. A secondary
    /// program is always over after its first frame.
    /// Threads  always the same one; hosts may call pause(), resume() and stop() from inside
    State runFrame();

    void pause();  ///< from the next frame on; pending sleeps and read time-outs stand still
    void resume();
    void stop();  ///< ends the program; inside runFrame(): when the current statement returns

    State state() const;
    bool ended() const { return state() >= State::Finished; }
    const std::optional<RuntimeError>& error() const;
    const Program& program() const;

    /// Line the main body stands at (script_control_line), 0 before the first frame.
    int currentLine() const;
    std::int64_t frame() const;  ///< frames run so far
    int threadCount() const;     ///< main body included
    /// A global variable's value now, or nullptr. Valid until the next frame.
    const Value* global(std::string_view name) const;
    /// Lines from outside, while the program stands in interpreter_mode().
    InterpreterMode& mode();

private:
    class Machine;
    std::unique_ptr<Machine> machine_;
};

}  // namespace tiller::simulator::urscript
