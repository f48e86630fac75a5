// SPDX-License-Identifier: MIT
#pragma once

// Runs programs with the program states of a controller: one main program and any number of secondary
// programs in parallel. A new main program replaces the running program, unless it does not compile. Source:
// client interface manual, dashboard guide.

#include <chrono>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/modes.h"
#include "robot/simulator/plant/running_programs.h"
#include "robot/simulator/programs/external_control.h"
#include "robot/simulator/urscript/interpreter.h"
#include "robot/simulator/urscript/program.h"
#include "robot/simulator/urscript/source_splitter.h"

namespace tiller::simulator {

class Plant;

class ProgramRunner final : public RunningPrograms {
public:
    /// Minimum duration of a stop [s], so that clients can observe the state STOPPING.
    static constexpr double kStopTime = 0.02;

    /// Minimum duration of a program [s], so that clients that do not sample every period can observe it.
    static constexpr double kMinPlayingTime = 0.01;

    ProgramRunner(Plant& plant, urscript::Host& host);
    ~ProgramRunner() { endAll(); }
    ProgramRunner(const ProgramRunner&) = delete;
    ProgramRunner& operator=(const ProgramRunner&) = delete;

    /// Accepts a unit from a script port. The unit is compiled at once and runs starting with the next period.
    /// Compile errors are reported to primary clients.
    void submit(const urscript::SourceSplitter::Unit& unit);
    /// Options for compiling a program for this controller.
    urscript::CompileOptions compileOptions() const;
    /// Like submit(), for the text of a program file. Returns false if the text does not compile.
    bool submitText(std::string_view text);
    /// Runs a program with External Control nodes when the provider's script has arrived. If no script
    /// arrives, the program shows a message in place of the node and waits for the operator.
    void submitControlled(std::string text, ScriptProvider provider);

    void requestStop() override;
    /// True while waiting for the script of an External Control node, which requires event processing.
    bool awaitsScript() const { return controlled_ != nullptr; }
    /// True if a stop has been requested but has not begun.
    bool isStopRequested() const;
    void stopNow() override;
    /// Ends all programs without a message. Called when the controller shuts down.
    void endAll();
    void pause() override;
    void resume() override;
    void haltForProtectiveStop() override;

    RuntimeState state() const override { return state_; }
    /// True if the main program came from a program file; false if it was sent over a socket.
    bool isFileProgram() const { return isActive() && fromFile_; }
    std::uint32_t currentLine() const override;
    /// The main program; null if no program is running.
    const urscript::Interpreter* mainProgram() const { return ended_ ? nullptr : main_.get(); }
    /// Like mainProgram(), but also non-null between the end of the main body and the report of this end.
    const urscript::Interpreter* unreportedProgram() const { return main_.get(); }
    /// The error of the last main program; empty if it did not fail.
    const std::optional<urscript::RuntimeError>& failure() const { return failure_; }
    /// Number of main programs started.
    std::uint64_t starts() const { return starts_; }
    /// Interpreter mode of the main program; null if no program is running.
    urscript::InterpreterMode* interpreterMode() { return main_ && !ended_ ? &main_->mode() : nullptr; }

    void step();

    bool isEndingMain() const override { return !runningSecondary_; }

private:
    using Unit = urscript::SourceSplitter::Unit;
    struct NextProgram {
        std::shared_ptr<const urscript::Program> program;  ///< null: request to stop
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
    urscript::Host& host_;
    std::deque<NextProgram> requests_;
    std::unique_ptr<Controlled> controlled_;  ///< program that is waiting for its script
    std::unique_ptr<urscript::Interpreter> main_;
    std::vector<std::unique_ptr<urscript::Interpreter>> secondaries_;
    std::string name_;  ///< name of the main program
    RuntimeState state_ = RuntimeState::Stopped;
    std::optional<urscript::RuntimeError> failure_;
    double stopping_ = 0;  ///< time since the beginning of STOPPING [s]
    double begun_ = 0;     ///< start time of the main program [s]
    std::uint64_t starts_ = 0;
    bool fromFile_ = false;
    bool ended_ = false;  ///< the main body has ended; the end is reported in a later period
    bool runningSecondary_ = false;
};

}  // namespace tiller::simulator
