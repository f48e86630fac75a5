// SPDX-License-Identifier: MIT
#pragma once

// Pauses a running program between its steps. The program calls tiller_step() or, at a breakpoint, tiller_break() at
// the beginning of each step, and tiller_turn() at the beginning of each iteration of its outermost endless loop.
// The functions read one integer input register, so the client decides how many steps may begin.

#include <QString>
#include <cstdint>

namespace tiller::script {

/// Output integer register to which a project's program writes the number of the current step. The control
/// program does not use this register.
inline constexpr int kStepRegister = 47;

/// Output integer register with the number of steps that have begun, n, while the program runs, and -1 - n
/// while the program waits before the next step. The control program does not use this register.
inline constexpr int kGateRegister = 46;

/// Limits the steps that a running program may begin.
struct StepGate {
    static constexpr std::int32_t kUnlimited = 1'000'000'000;
    /// Total number of steps that may begin. kUnlimited + n: no limit, but the program stops at each breakpoint
    /// before which n or more steps have begun.
    std::int32_t permitted = kUnlimited;
    bool endsWithCycle = false;  ///< the program ends before the next iteration of its outermost endless loop

    /// Value of the input register. Never 0, so a register that was not written permits no step.
    std::int32_t value() const { return endsWithCycle ? -1 - permitted : 1 + permitted; }
    bool operator==(const StepGate&) const = default;
};

/// URScript definitions of the functions, to be inserted at the beginning of a program.
/// inputRegister  integer register with StepGate::value()
///
/// tiller_step(number)  writes the number to kStepRegister and waits until another step may begin
/// tiller_break(number) for a step with a breakpoint: the same, see StepGate::permitted
/// tiller_turn(turn)    returns `turn`, or ends the program at standstill if it must end with its cycle
QString stepGateScript(int inputRegister);

}  // namespace tiller::script
