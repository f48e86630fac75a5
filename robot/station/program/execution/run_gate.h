// SPDX-License-Identifier: MIT
#pragma once

// Pauses a running program before its steps, see script::StepGate.

#include "robot/script/step_gate.h"
#include "robot/station/program/execution/step_log.h"

namespace tiller::program {

/// The state of the step gate of one run. The argument `log` is always the log of this run.
class RunGate {
public:
    /// permitted  number of steps before the program pauses
    explicit RunGate(std::int32_t permitted = script::StepGate::kUnlimited) : gate_{permitted, false} {}

    const script::StepGate& value() const { return gate_; }

    /// True after pause() or step(), and while the program waits at a breakpoint.
    bool isPaused(const StepLog& log) const;
    bool isAtBreakpoint(const StepLog& log) const;

    void pause(const StepLog& log);   ///< The program pauses before its next step.
    void resume(const StepLog& log);  ///< The program continues to the next breakpoint.
    void step(const StepLog& log);    ///< A waiting program runs one step.
    /// If true, the program ends before the next iteration of its outermost endless loop.
    void setEndsWithCycle(bool ends) { gate_.endsWithCycle = ends; }
    /// Sets a change of a variable, which the waiting program applies.
    void change(const script::VariableChange& change) { gate_.change = change; }
    /// Withdraws a change that the program has not applied. resume() and step() also withdraw it, because the
    /// program could otherwise apply the change the next time it waits.
    void withdrawChange() { gate_.change.number = 0; }

    friend bool operator==(const RunGate&, const RunGate&) = default;

private:
    script::StepGate gate_;
};

}  // namespace tiller::program
