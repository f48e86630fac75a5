// SPDX-License-Identifier: MIT
#pragma once

// Runs one program, one controller frame at a time. Within a frame, every script thread runs until it blocks,
// ends or has used its time slice. No thread runs between frames. The order is deterministic: the thread with
// the largest remaining slice runs first. Among equal slices, the oldest thread runs first, except that the
// main program runs last (see Limits::mainFirst). A thread started in a frame still runs in this frame.
//
// The host calls runFrame() once in each control period and then steps the arm. The destructor and stop() end
// the program and notify the host.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "robot/simulator/urscript/host.h"
#include "robot/simulator/urscript/program.h"
#include "robot/simulator/urscript/value.h"

namespace tiller::simulator::urscript {

/// The error that ended a program early. Line and column are counted from 1 in the compiled text.
struct RuntimeError {
    int line = 0;
    int column = 0;
    std::string text;
    bool overrun = false;  ///< infinite loop without waiting
};

struct Limits {
    std::int64_t threadOperationsPerFrame = 1'000'000;  ///< more operations are treated as an infinite loop
    /// A thread that reads a socket after this many operations waits for the next frame. Otherwise, a loop that
    /// always finds data would never end its frame.
    std::int64_t readingOperationsPerFrame = 100'000;
    std::int64_t frameOperations = 4'000'000;  ///< operations of all threads together
    int callDepth = 200;
    int threads = 128;
    std::size_t listLength = 100'000;
    std::uint64_t randomSeed = 1;
    /// Order among threads with equal slices. True: the main program runs first. False: it runs last, so that
    /// programs in which a thread copies an input for the main program use the newest copy. An example is the
    /// vendor's RTDE control loop.
    bool mainFirst = false;
    bool threadsBeginNextFrame = false;     ///< false: threads begin in the period in which they are started
    bool remoteServersMayBeAbsent = false;  ///< rpc_factory() does not check its server
};

class InterpreterMode;

class Interpreter {
public:
    enum class State {
        Running,
        Paused,
        Finished,  ///< the main body has ended, or a thread has executed `halt`
        Stopped,   ///< ended by stop()
        Failed,    ///< see error()
    };

    Interpreter(std::shared_ptr<const Program> program, Host& host, const Limits& limits = {});
    ~Interpreter();
    Interpreter(const Interpreter&) = delete;
    Interpreter& operator=(const Interpreter&) = delete;

    /// Runs one frame of host().stepTime(). No effect unless the program is running. A secondary program
    /// always ends within its first frame.
    /// Threads  always the same thread; hosts may call pause(), resume() and stop() from inside this function
    State runFrame();

    void pause();  ///< Pauses starting with the next frame; sleeps and read timeouts pause too
    void resume();
    void stop();  ///< Ends the program; inside runFrame(): after the current statement

    State state() const;
    bool ended() const { return state() >= State::Finished; }
    const std::optional<RuntimeError>& error() const;
    const Program& program() const;

    /// Current line of the main body (script_control_line); 0 before the first frame.
    int currentLine() const;
    std::int64_t frame() const;  ///< number of frames run
    int threadCount() const;     ///< including the main body
    /// Current value of a global variable; null if it does not exist. Valid until the next frame.
    const Value* global(std::string_view name) const;
    /// Interface for lines sent by clients while the program is in interpreter_mode().
    InterpreterMode& mode();

private:
    class Machine;
    std::unique_ptr<Machine> machine_;
};

}  // namespace tiller::simulator::urscript
