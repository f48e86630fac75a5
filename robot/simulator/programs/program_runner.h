// SPDX-License-Identifier: MIT
#pragma once

// Which program runs: one main program at a time, secondary ones beside it, with the program states of a
// controller around them. A new main program replaces the one that runs; a text that does not compile
// replaces nothing. Source: client interface manual, dashboard guide.

#include <chrono>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/modes.h"
#include "robot/simulator/programs/external_control.h"
#include "robot/simulator/urscript/interpreter.h"
#include "robot/simulator/urscript/program.h"
#include "robot/simulator/urscript/source_splitter.h"

namespace tiller::simulator {

class Plant;
class ScriptHost;

class ProgramRunner {
public:
    /// A stop takes at least this long, so that clients can see it under way [s].
    static constexpr double kStopTime = 0.02;

    /// So does a program, however short: a client that looks less often than every period misses none [s].
    static constexpr double kLeastPlaying = 0.01;

    ProgramRunner(Plant& plant, ScriptHost& host);
    ~ProgramRunner() { endAll(); }
    ProgramRunner(const ProgramRunner&) = delete;
    ProgramRunner& operator=(const ProgramRunner&) = delete;

    /// Takes a unit from a script port: compiles it now, runs it from the next period on. What does not
    /// compile is reported to primary clients.
    void submit(const urscript::SourceSplitter::Unit& unit);
    /// The same for a program file. False when it does not compile.
    bool submitText(std::string_view text);
    /// For one with External Control nodes: it begins once the provider's script has come. Without it, the
    /// program tells the operator so in place of the node, and waits.
    void submitControlled(std::string text, ScriptProvider provider);

    void requestStop();
    /// Of an External Control node; it needs events to be processed.
    bool awaitsScript() const { return controlled_ != nullptr; }
    /// A stop has been asked for and not begun.
    bool isStopRequested() const;
    /// Ends the main program within this call.
    void stopNow();
    /// Ends every program without a word: the controller goes away.
    void endAll();
    void pause();
    void resume();
    /// A protective stop: a program from a file waits for `play`, one that came over a socket ends and has to
    /// be sent again. Source: Dashboard Server guide, "unlock protective stop"; the ROS 2 driver, which sends it again
    void haltForProtectiveStop();

    RuntimeState state() const { return state_; }
    /// Anything but stopped.
    bool isActive() const { return state_ != RuntimeState::Stopped; }
    bool isPaused() const { return state_ == RuntimeState::Paused; }
    /// The main program came from a program file, not over a socket.
    bool isFileProgram() const { return isActive() && fromFile_; }
    std::uint32_t currentLine() const;
    /// The main program; null when none runs.
    const urscript::Interpreter* mainProgram() const { return ended_ ? nullptr : main_.get(); }
    /// Why the last main program failed; nothing: it did not.
    const std::optional<urscript::RuntimeError>& failure() const { return failure_; }
    /// Main programs started so far.
    std::uint64_t starts() const { return starts_; }
    /// Of the main program; null when none runs.
    urscript::InterpreterMode* interpreterMode() { return main_ && !ended_ ? &main_->mode() : nullptr; }

    void step();

    /// From the host, while a frame runs: whose program ended.
    bool isEndingMain() const { return !runningSecondary_; }

private:
    using Unit = urscript::SourceSplitter::Unit;
    struct NextProgram {
        std::shared_ptr<const urscript::Program> program;  ///< null: stop
        bool fromFile = false;
    };

    struct Controlled {
        Controlled(std::string program, ScriptProvider from, std::chrono::milliseconds silence)
            : text(std::move(program)), provider(std::move(from)), request(provider, silence) {}
        std::string text;
        ScriptProvider provider;
        ControlScriptRequest request;
    };

    void runCommand(std::string_view words);
    void takeControlScript();
    void setSpeed(std::string_view fraction);
    bool enqueue(std::string_view text, bool fromFile);
    void takeRequests();
    void startMain(std::shared_ptr<const urscript::Program> program);
    void startSecondary(std::shared_ptr<const urscript::Program> program);
    void stepMain();
    void stepSecondaries();
    void beginStopping();
    void finishStopping();
    void reportFailure(const urscript::Interpreter& interpreter);

    Plant& plant_;
    ScriptHost& host_;
    std::deque<NextProgram> requests_;
    std::unique_ptr<Controlled> controlled_;  ///< waits for its script
    std::unique_ptr<urscript::Interpreter> main_;
    std::vector<std::unique_ptr<urscript::Interpreter>> secondaries_;
    std::string name_;  ///< of the main program
    RuntimeState state_ = RuntimeState::Stopped;
    std::optional<urscript::RuntimeError> failure_;
    double stopping_ = 0;  ///< [s] in STOPPING
    double begun_ = 0;     ///< when the main program started [s]
    std::uint64_t starts_ = 0;
    bool fromFile_ = false;
    bool ended_ = false;  ///< the main body ended; told in a later period
    bool runningSecondary_ = false;
};

}  // namespace tiller::simulator
