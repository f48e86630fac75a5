// SPDX-License-Identifier: MIT
#pragma once

// Arithmetic and comparison of values as defined by the language. All functions throw Fault for incompatible
// types.

#include "robot/simulator/urscript/bytecode.h"
#include "robot/simulator/urscript/value.h"

namespace tiller::simulator::urscript {

/// Applies Op::Add ... Op::Modulo to numbers, to lists and matrices element by element, as matrix product,
/// and to strings with `+`.
Value arithmetic(Op op, const Value& left, const Value& right);
Value negated(const Value& v);
/// Applies Op::Equal ... Op::GreaterEqual.
bool compare(Op op, const Value& left, const Value& right);
/// Converts a value to a condition: a bool, a number (true if nonzero) or a string (true if nonempty).
bool truth(const Value& v);

/// `[a, b, ...]`: a list, or a matrix if the elements are lists of numbers.
Value makeList(const Value* elements, std::size_t count, std::size_t maxLength);
Value makePose(const Value* elements);

/// `v[i]` and `v[row, column]`.
Value indexed(const Value& v, const Value& i);
Value indexed(const Value& v, const Value& row, const Value& column);
void assignIndexed(Value& v, const Value& i, const Value& element);
void assignIndexed(Value& v, const Value& row, const Value& column, const Value& element);
/// Converts an index and checks that 0 <= index < size.
std::size_t checkedIndex(const Value& i, std::size_t size);

}  // namespace tiller::simulator::urscript
