// SPDX-License-Identifier: MIT
#pragma once

// Interpreter mode: while the main body is in interpreter_mode(), lines from outside are compiled for the running
// program and executed by it in order. Source: interpreter mode chapter of the script manual.

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robot/simulator/urscript/linked_code.h"

namespace tiller::simulator::urscript {

/// Threads  that of Interpreter::runFrame(), between frames.
class InterpreterMode {
public:
    /// Lines that may wait; more are discarded.
    static constexpr std::size_t kMostWaiting = 2'000;
    /// Functions and variables lines may define until they are cleared.
    static constexpr std::size_t kMostDefinitions = 2'000;
    /// Lines run in one frame; the rest has the next ones.
    static constexpr int kLinesPerFrame = 100;

    explicit InterpreterMode(LinkedCode& code) : code_(code) {}

    // ---- from outside

    /// Lines are taken.
    bool isActive() const { return active_ && !ending_; }

    struct Reply {
        enum class Kind {
            Ack,      ///< queued, with an id counting from 1
            Discard,  ///< refused, with a reason
            Wait,     ///< a clear_interpreter() is on its way: ask again later
        };
        Kind kind = Kind::Discard;
        std::uint32_t id = 0;
        std::string reason;
    };
    /// Compiles one line and queues it.
    Reply submit(std::string_view line);
    /// `skipbuffer`: drops what has not begun.
    void skip();
    /// `abort`: ends the movej or movel under way, nothing else.
    void abortMove() { abort_ = true; }

    struct Counts {
        std::uint32_t lastInterpreted = 0;
        std::uint32_t lastExecuted = 0;  ///< execution has begun
        std::uint32_t lastCleared = 0;
        std::uint32_t unexecuted = 0;
    };
    const Counts& counts() const { return counts_; }

    // ---- from the program

    /// interpreter_mode() is reached, at first or again after a line.
    enum class Next { Line, Nothing, End };
    Next proceed(bool clearQueueOnEnter, bool clearOnEnd);
    bool isInLine() const { return inLine_; }
    void requestEnd() { ending_ = active_; }
    void requestClear() { clearing_ = active_; }

    // ---- from the machine

    void beginFrame() { linesLeft_ = kLinesPerFrame; }
    /// The next line, to be run now; valid until the next one.
    const Unit& begin();
    void lineDone();
    bool takeAbort() { return std::exchange(abort_, false); }
    /// What lines defined is to be forgotten now.
    bool takeForget() { return std::exchange(forget_, false); }
    void forget();

private:
    struct Line {
        std::uint32_t id = 0;
        std::unique_ptr<Unit> unit;
    };
    void clear();
    void retire(std::unique_ptr<Unit> unit);

    LinkedCode& code_;
    std::deque<Line> queue_;
    std::unique_ptr<Unit> running_;
    std::vector<std::unique_ptr<Unit>> definitions_;  ///< lines that others may call into
    Counts counts_;
    int linesLeft_ = kLinesPerFrame;
    bool active_ = false;
    bool ending_ = false;
    bool clearing_ = false;  ///< once the line under way is over
    bool clearOnEnd_ = true;
    bool awaitsClear_ = false;  ///< the last line queued clears: what follows has to wait for it
    bool inLine_ = false;
    bool abort_ = false;
    bool forget_ = false;
};

}  // namespace tiller::simulator::urscript
