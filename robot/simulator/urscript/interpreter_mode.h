// SPDX-License-Identifier: MIT
#pragma once

// Interpreter mode: while the main body is in interpreter_mode(), lines from clients are compiled for the
// running program, which executes them in order. Source: interpreter mode chapter of the script manual.

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robot/simulator/urscript/linked_code.h"

namespace tiller::simulator::urscript {

/// Threads  the thread of Interpreter::runFrame(), between frames
class InterpreterMode {
public:
    /// Maximum number of waiting lines. Further lines are discarded.
    static constexpr std::size_t kMaxWaiting = 2'000;
    /// Maximum number of functions and variables defined by lines before they must be cleared.
    static constexpr std::size_t kMaxDefinitions = 2'000;
    /// Maximum number of lines executed in one frame. The next frames execute the remaining lines.
    static constexpr int kLinesPerFrame = 100;

    explicit InterpreterMode(LinkedCode& code) : code_(code) {}

    // ---- called for clients

    /// True if lines are accepted.
    bool isActive() const { return active_ && !ending_; }

    struct Reply {
        enum class Kind {
            Ack,      ///< queued, with an ID counted from 1
            Discard,  ///< refused, with the reason
            Wait,     ///< a clear_interpreter() is pending; retry later
        };
        Kind kind = Kind::Discard;
        std::uint32_t id = 0;
        std::string reason;
    };
    /// Compiles one line and queues it.
    Reply submit(std::string_view line);
    /// `skipbuffer`: discards lines that have not started.
    void skip();
    /// `abort`: ends only the current movej or movel.
    void abortMove() { abort_ = true; }

    struct Counts {
        std::uint32_t lastInterpreted = 0;
        std::uint32_t lastExecuted = 0;  ///< number of the last line whose execution has begun
        std::uint32_t lastCleared = 0;
        std::uint32_t unexecuted = 0;
    };
    const Counts& counts() const { return counts_; }

    // ---- called by the program

    /// Result of proceed(), which is called when the program reaches interpreter_mode() and after each line.
    enum class Next { Line, Nothing, End };
    Next proceed(bool clearQueueOnEnter, bool clearOnEnd);
    bool isInLine() const { return inLine_; }
    void requestEnd() { ending_ = active_; }
    void requestClear() { clearing_ = active_; }

    // ---- called by the virtual machine

    void beginFrame() { linesLeft_ = kLinesPerFrame; }
    /// Returns the next line to run. Valid until the next call.
    const Unit& begin();
    void lineDone();
    bool takeAbort() { return std::exchange(abort_, false); }
    /// Returns true once if the definitions made by lines must be discarded.
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
    std::vector<std::unique_ptr<Unit>> definitions_;  ///< lines with definitions for later lines
    Counts counts_;
    int linesLeft_ = kLinesPerFrame;
    bool active_ = false;
    bool ending_ = false;
    bool clearing_ = false;  ///< clear after the current line
    bool clearOnEnd_ = true;
    bool awaitsClear_ = false;  ///< the last queued line clears; later lines must wait for it
    bool inLine_ = false;
    bool abort_ = false;
    bool forget_ = false;
};

}  // namespace tiller::simulator::urscript
