// SPDX-License-Identifier: MIT
#pragma once

// The script of a program in the simulated controller, with the inputs and the operator actions of
// PreviewOptions.

#include <optional>
#include <vector>

#include "robot/simulator/script_run.h"
#include "robot/station/program/preview/preview.h"

namespace tiller::program {

/// Threads  one at a time. No function blocks.
class SimulatedRun {
public:
    /// script and options  must outlive the run
    SimulatedRun(const project::Project& project, const ProgramScript& script,
                 const ScriptOptions& scriptOptions, const PreviewOptions& options);

    /// TCP before the script sets one, flange to TCP.
    static Pose tcpAtStart(const project::Project& project, const ProgramScript& script);

    /// Returns  the error of the script; empty if there is none
    std::optional<simulator::ScriptFault> start() { return start(script_.text); }
    /// text  the script with additions, e.g. for a heartbeat
    std::optional<simulator::ScriptFault> start(const QString& text);
    /// Runs one control period.
    /// Returns  false when the script has ended
    bool step();

    simulator::ScriptRun& controller() { return run_; }
    const simulator::ScriptRun& controller() const { return run_; }
    double time() const { return run_.time(); }  ///< since the start [s]
    /// Input changes that the run has not reached yet, with the remaining times.
    std::vector<InputChange> remainingInputs() const;
    /// Input values set so far, as changes at time 0.
    std::vector<InputChange> inputs() const;
    int questions() const { return questions_; }  ///< number of questions to the operator so far
    /// Indices of the answers whose type does not match the question.
    const std::vector<int>& unfitAnswers() const { return unfitAnswers_; }

private:
    void applyInputs();
    void answerOperator();

    const ProgramScript& script_;
    const PreviewOptions& options_;
    simulator::ScriptRun run_;
    std::vector<InputChange> inputs_;
    std::size_t nextInput_ = 0;
    std::optional<double> askedAt_;
    int questions_ = 0;
    std::vector<int> unfitAnswers_;
};

}  // namespace tiller::program
