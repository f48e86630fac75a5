// SPDX-License-Identifier: MIT
#pragma once

// Inlined operations on numbers, which are the most frequent. All other operations are in operators.h.

#include <algorithm>
#include <cstdint>

#include "robot/simulator/urscript/operators.h"

namespace tiller::simulator::urscript {

// Number of elements of a list, matrix or struct; 0 for other values.
inline std::int64_t elementCount(const Value& v) {
    return static_cast<std::int64_t>(v.is(Value::Type::List)     ? v.list().size()
                                     : v.is(Value::Type::Matrix) ? v.matrix().numbers.size()
                                     : v.is(Value::Type::Struct) ? v.structure().members.size()
                                                                 : 0);
}

// Number of operations charged for an operator on lists, so that the operation limit also bounds its time.
inline std::int64_t costOf(Op op, const Value& left, const Value& right) {
    const std::int64_t most = std::max(elementCount(left), elementCount(right));
    if (op == Op::Multiply && left.is(Value::Type::Matrix)) {
        return most * static_cast<std::int64_t>(right.is(Value::Type::Matrix) ? right.matrix().cols : 1) / 8;
    }
    return most / 8;
}

// Inlined operations on ints and floats; an int and a float result in a float. Returns false if this function
// does not handle the operator or the operands.
inline bool fastArithmetic(Op op, Value& left, const Value& right) {
    if (left.is(Value::Type::Float) || right.is(Value::Type::Float)) {
        if (!left.isNumber() || !right.isNumber()) {
            return false;
        }
        const double a = left.number();
        const double b = right.number();
        switch (op) {
            case Op::Add:
                left.setFloat(a + b);
                return true;
            case Op::Subtract:
                left.setFloat(a - b);
                return true;
            case Op::Multiply:
                left.setFloat(a * b);
                return true;
            case Op::Divide:
                left.setFloat(a / b);
                return true;
            default:
                return false;
        }
    }
    if (left.is(Value::Type::Int) && right.is(Value::Type::Int)) {
        const auto a = static_cast<std::uint32_t>(left.asInt());
        const auto b = static_cast<std::uint32_t>(right.asInt());
        switch (op) {
            case Op::Add:
                left.setInt(static_cast<std::int32_t>(a + b));
                return true;
            case Op::Subtract:
                left.setInt(static_cast<std::int32_t>(a - b));
                return true;
            case Op::Multiply:
                left.setInt(static_cast<std::int32_t>(a * b));
                return true;
            default:
                return false;
        }
    }
    return false;
}

inline bool fastCompare(Op op, double a, double b) {
    switch (op) {
        case Op::Equal:
            return a == b;
        case Op::NotEqual:
            return a != b;
        case Op::Less:
            return a < b;
        case Op::Greater:
            return a > b;
        case Op::LessEqual:
            return a <= b;
        default:
            return a >= b;
    }
}

inline bool fastTruthValue(const Value& v) {
    return v.is(Value::Type::Bool) ? v.asBool() : truth(v);
}

}  // namespace tiller::simulator::urscript
