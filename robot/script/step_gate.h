// SPDX-License-Identifier: MIT
#pragma once

// Pauses a running program between its steps. The program calls tiller_step() or, at a breakpoint, tiller_break() at
// the beginning of each step, and tiller_turn() at the beginning of each iteration of its outermost endless loop.
// The functions read one integer input register, so the client decides how many steps may begin. While the program
// waits, the client can change the values of its global variables.

#include <QString>
#include <cstdint>
#include <vector>

namespace tiller::script {

/// Output integer register to which a project's program writes the number of the current step. The control
/// program does not use this register.
inline constexpr int kStepRegister = 47;

/// Output integer register with the number of steps that have begun, n, while the program runs, and -1 - n
/// while the program waits before the next step. The control program does not use this register.
inline constexpr int kGateRegister = 46;

/// A global variable whose value can be changed while the program waits.
struct GateVariable {
    enum class Type : std::uint8_t { Number, Whole, Flag };
    QString name;
    Type type = Type::Number;
    bool operator==(const GateVariable&) const = default;
};

/// The new value of a variable. The waiting program takes each change once.
struct VariableChange {
    std::int32_t number = 0;    ///< number of the change in this run, counted from 1; 0: no change
    std::int32_t variable = 0;  ///< index of the GateVariable
    double value = 0;           ///< Whole: an integer of 32 bits; Flag: 0 or 1
    bool operator==(const VariableChange&) const = default;
};

/// Limits the steps that a running program may begin.
struct StepGate {
    static constexpr std::int32_t kUnlimited = 1'000'000'000;
    /// Total number of steps that may begin. kUnlimited + n: no limit, but the program stops at each breakpoint
    /// before which n or more steps have begun.
    std::int32_t permitted = kUnlimited;
    bool endsWithCycle = false;  ///< the program ends before the next iteration of its outermost endless loop
    VariableChange change = {};

    /// Value of the input register for the steps. Never 0, so a register that was not written permits no step.
    std::int32_t value() const { return endsWithCycle ? -1 - permitted : 1 + permitted; }
    bool operator==(const StepGate&) const = default;
};

/// The input registers of the gate, and the variables that it can change.
struct GateInputs {
    int steps = 0;   ///< integer register with StepGate::value()
    int whole = 0;   ///< integer register with VariableChange::value, rounded
    int change = 0;  ///< first of three float registers: value, variable and number of a VariableChange
    std::vector<GateVariable> variables = {};
};

/// URScript definitions of the functions, to be inserted at the beginning of a program.
///
/// tiller_step(number)   writes the number to kStepRegister and waits until another step may begin
/// tiller_break(number)  same as tiller_step(), for a step with a breakpoint; see StepGate::permitted
/// tiller_turn(turn)     returns `turn`, the number of the iteration. If StepGate::endsWithCycle is set,
///                       waits for standstill and ends the program before every iteration except the first
QString stepGateScript(const GateInputs& inputs);

}  // namespace tiller::script
