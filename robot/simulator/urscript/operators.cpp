// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/operators.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/simulator/urscript/call.h"
#include "robot/simulator/urscript/value_format.h"

namespace tiller::simulator::urscript {

namespace {

using Type = Value::Type;

const char* symbol(Op op) {
    switch (op) {
        case Op::Add:
            return "+";
        case Op::Subtract:
            return "-";
        case Op::Multiply:
            return "*";
        case Op::Divide:
            return "/";
        case Op::Modulo:
            return "%";
        case Op::Less:
            return "<";
        case Op::Greater:
            return ">";
        case Op::LessEqual:
            return "<=";
        case Op::GreaterEqual:
            return ">=";
        default:
            return "?";
    }
}

[[noreturn]] void unsupported(Op op, const Value& left, const Value& right) {
    fault(std::string("Type error: unsupported operands for ") + symbol(op) + ": " + left.typeName() +
          " and " + right.typeName());
}

double apply(Op op, double a, double b) {
    switch (op) {
        case Op::Add:
            return a + b;
        case Op::Subtract:
            return a - b;
        case Op::Multiply:
            return a * b;
        case Op::Divide:
            return a / b;
        default:
            return std::fmod(a, b);
    }
}

// 32-bit arithmetic with wrap-around, as on the controller.
std::int32_t applyInt(Op op, std::int32_t a, std::int32_t b) {
    const auto ua = static_cast<std::uint32_t>(a);
    const auto ub = static_cast<std::uint32_t>(b);
    switch (op) {
        case Op::Add:
            return static_cast<std::int32_t>(ua + ub);
        case Op::Subtract:
            return static_cast<std::int32_t>(ua - ub);
        case Op::Multiply:
            return static_cast<std::int32_t>(ua * ub);
        default:
            if (b == 0) {
                fault("Division by zero");
            }
            return b == -1 ? 0 : a % b;
    }
}

// The numbers of a list or matrix, and whether all are integers.
struct Elements {
    const std::vector<double>* numbers = nullptr;
    double scalar = 0;
    bool integer = false;
    double at(std::size_t i) const { return numbers != nullptr ? (*numbers)[i] : scalar; }
};

bool elementsOf(const Value& v, Elements& out) {
    if (v.isNumber()) {
        out = {nullptr, v.number(), v.is(Type::Int)};
    } else if (v.is(Type::List) && v.list().isNumeric()) {
        out = {&v.list().numbers, 0, v.list().kind == ListData::Kind::Int};
    } else if (v.is(Type::Matrix)) {
        out = {&v.matrix().numbers, 0, v.matrix().integer};
    } else {
        return false;
    }
    return true;
}

// Applies the operation element by element. Ints remain ints except in division.
bool elementwise(Op op, const Elements& a, const Elements& b, std::size_t count, std::vector<double>& out) {
    const bool integer = a.integer && b.integer && op != Op::Divide;
    out.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = integer
                     ? applyInt(op, static_cast<std::int32_t>(a.at(i)), static_cast<std::int32_t>(b.at(i)))
                     : apply(op, a.at(i), b.at(i));
    }
    return integer;
}

Value product(const Value& left, const Value& right) {
    const MatrixData& m = left.matrix();
    const bool vector = right.is(Type::List);
    const std::vector<double>& other = vector ? right.list().numbers : right.matrix().numbers;
    const std::size_t rows = vector ? other.size() : right.matrix().rows;
    const std::size_t cols = vector ? 1 : right.matrix().cols;
    if (m.cols != rows) {
        fault("Dimensions do not match: " + std::to_string(m.rows) + "x" + std::to_string(m.cols) + " and " +
              std::to_string(rows) + "x" + std::to_string(cols));
    }
    MatrixData out;
    out.rows = m.rows;
    out.cols = cols;
    out.integer = m.integer && (vector ? right.list().kind == ListData::Kind::Int : right.matrix().integer);
    out.numbers.assign(out.rows * out.cols, 0.0);
    for (std::size_t r = 0; r < out.rows; ++r) {
        for (std::size_t c = 0; c < cols; ++c) {
            double sum = 0;
            for (std::size_t k = 0; k < rows; ++k) {
                sum += m.numbers[r * m.cols + k] * other[k * cols + c];
            }
            // An int result that does not fit into 32 bits becomes a float.
            out.integer = out.integer && std::abs(sum) <= std::numeric_limits<std::int32_t>::max();
            out.numbers[r * cols + c] = sum;
        }
    }
    if (!vector) {
        return Value::matrix(std::move(out));
    }
    ListData list;
    list.kind = out.integer ? ListData::Kind::Int : ListData::Kind::Float;
    list.numbers = std::move(out.numbers);
    return Value::list(std::move(list));
}

Value matrixArithmetic(Op op, const Value& left, const Value& right) {
    if (op == Op::Multiply && left.is(Type::Matrix) && !right.isNumber()) {
        if (right.is(Type::Matrix) || (right.is(Type::List) && right.list().isNumeric())) {
            return product(left, right);
        }
        unsupported(op, left, right);
    }
    const MatrixData& shape = left.is(Type::Matrix) ? left.matrix() : right.matrix();
    Elements a, b;
    if (!elementsOf(left, a) || !elementsOf(right, b) || left.is(Type::List) || right.is(Type::List)) {
        unsupported(op, left, right);
    }
    if (left.is(Type::Matrix) && right.is(Type::Matrix) &&
        (left.matrix().rows != right.matrix().rows || left.matrix().cols != right.matrix().cols)) {
        fault("Dimensions of matrices do not match");
    }
    MatrixData out;
    out.rows = shape.rows;
    out.cols = shape.cols;
    out.integer = elementwise(op, a, b, shape.numbers.size(), out.numbers);
    return Value::matrix(std::move(out));
}

}  // namespace

Value arithmetic(Op op, const Value& left, const Value& right) {
    if (left.is(Type::Int) && right.is(Type::Int) && op != Op::Divide) {
        return applyInt(op, left.asInt(), right.asInt());
    }
    if (left.isNumber() && right.isNumber()) {
        return apply(op, left.number(), right.number());
    }
    if (left.is(Type::Matrix) || right.is(Type::Matrix)) {
        return matrixArithmetic(op, left, right);
    }
    if (left.is(Type::String) && right.is(Type::String) && op == Op::Add) {
        if (left.string().size() + right.string().size() > kMaxStringLength) {
            fault("String is too long");
        }
        return Value(left.string() + right.string());
    }
    Elements a, b;
    if (!elementsOf(left, a) || !elementsOf(right, b)) {
        unsupported(op, left, right);
    }
    if (a.numbers != nullptr && b.numbers != nullptr && a.numbers->size() != b.numbers->size()) {
        fault("Lengths of lists do not match: " + std::to_string(a.numbers->size()) + " and " +
              std::to_string(b.numbers->size()));
    }
    ListData out;
    const std::size_t count = (a.numbers != nullptr ? a : b).numbers->size();
    out.kind = elementwise(op, a, b, count, out.numbers) ? ListData::Kind::Int : ListData::Kind::Float;
    return Value::list(std::move(out));
}

Value negated(const Value& v) {
    if (v.is(Type::Int)) {
        return applyInt(Op::Subtract, 0, v.asInt());
    }
    if (v.is(Type::Float)) {
        return -v.asFloat();
    }
    Elements e;
    if (!elementsOf(v, e)) {
        fault(std::string("Type error: unsupported operand for -: ") + v.typeName());
    }
    return arithmetic(Op::Multiply, Value(std::int32_t{-1}), v);
}

bool compare(Op op, const Value& left, const Value& right) {
    if (op == Op::Equal || op == Op::NotEqual) {
        return left.equals(right) == (op == Op::Equal);
    }
    if (!left.isNumber() || !right.isNumber()) {
        unsupported(op, left, right);
    }
    const double a = left.number();
    const double b = right.number();
    switch (op) {
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

bool truth(const Value& v) {
    switch (v.type()) {
        case Type::Bool:
            return v.asBool();
        case Type::Int:
        case Type::Float:
            return v.number() != 0;
        case Type::String:
            return !v.string().empty();
        default:
            fault(std::string("Type error: a condition must be a bool, not ") + v.typeName());
    }
}

Value makePose(const Value* elements) {
    std::array<double, 6> pose{};
    for (std::size_t i = 0; i < 6; ++i) {
        if (!elements[i].isNumber()) {
            fault(std::string("Type error: elements of a pose must be numbers, not ") +
                  elements[i].typeName());
        }
        pose[i] = elements[i].number();
    }
    return pose;
}

namespace {

Value makeMatrix(const Value* rows, std::size_t count, std::size_t maxLength) {
    MatrixData out;
    out.rows = count;
    out.cols = rows[0].list().numbers.size();
    if (out.cols == 0 || out.rows * out.cols > maxLength) {
        fault(out.cols == 0 ? "Rows of a matrix must not be empty" : "Matrix is too large");
    }
    out.numbers.reserve(out.rows * out.cols);
    for (std::size_t r = 0; r < count; ++r) {
        if (!rows[r].is(Type::List) || !rows[r].list().isNumeric()) {
            fault("Type error: rows of a matrix must be lists of numbers");
        }
        const ListData& row = rows[r].list();
        if (row.numbers.size() != out.cols) {
            fault("Rows of a matrix must be of equal length");
        }
        out.integer = out.integer && row.kind == ListData::Kind::Int;
        out.numbers.insert(out.numbers.end(), row.numbers.begin(), row.numbers.end());
    }
    return Value::matrix(std::move(out));
}

}  // namespace

Value makeList(const Value* elements, std::size_t count, std::size_t maxLength) {
    if (count > maxLength) {
        fault("List is too long");
    }
    if (count > 0 && elements[0].is(Type::List)) {
        return makeMatrix(elements, count, maxLength);
    }
    ListData out;
    for (std::size_t i = 0; i < count; ++i) {
        if (!out.insert(i, elements[i])) {
            fault(std::string("Type error: elements of a list must be of one type, not ") +
                  elements[0].typeName() + " and " + elements[i].typeName());
        }
    }
    Value v = Value::list(std::move(out));
    if (v.nested()) {
        std::size_t budget = maxLength;
        if (!v.withinBounds(kMaxValueDepth, budget)) {
            fault("List is too large");
        }
    }
    return v;
}

std::size_t checkedIndex(const Value& i, std::size_t size) {
    double index = -1;
    if (i.isNumber() && i.number() == std::floor(i.number())) {
        index = i.number();
    } else {
        fault(std::string("Type error: an index must be an integer, not ") +
              (i.isNumber() ? toStr(i) : i.typeName()));
    }
    if (!(index >= 0 && index < static_cast<double>(size))) {
        fault("Index out of bounds: " + toStr(i) + " in " + std::to_string(size) + " elements");
    }
    return static_cast<std::size_t>(index);
}

Value indexed(const Value& v, const Value& i) {
    switch (v.type()) {
        case Type::List:
            return v.list().at(checkedIndex(i, v.list().size()));
        case Type::Pose:
            return v.pose()[checkedIndex(i, 6)];
        case Type::Matrix: {
            const MatrixData& m = v.matrix();
            const double* row = m.numbers.data() + checkedIndex(i, m.rows) * m.cols;
            ListData out;
            out.kind = m.integer ? ListData::Kind::Int : ListData::Kind::Float;
            out.numbers.assign(row, row + m.cols);
            return Value::list(std::move(out));
        }
        case Type::Struct: {
            const auto& members = v.structure().members;
            return members[checkedIndex(i, members.size())].second;
        }
        default:
            fault(std::string("Type error: ") + v.typeName() + " cannot be indexed");
    }
}

Value indexed(const Value& v, const Value& row, const Value& column) {
    if (!v.is(Type::Matrix)) {
        fault(std::string("Type error: ") + v.typeName() + " has no rows and columns");
    }
    const MatrixData& m = v.matrix();
    const double element = m.numbers[checkedIndex(row, m.rows) * m.cols + checkedIndex(column, m.cols)];
    return m.integer ? Value(static_cast<std::int32_t>(element)) : Value(element);
}

void assignIndexed(Value& v, const Value& i, const Value& element) {
    switch (v.type()) {
        case Type::List: {
            const std::size_t index = checkedIndex(i, v.list().size());
            if (!v.ownList().set(index, element)) {
                fault(std::string("Type error: a ") + element.typeName() +
                      " cannot be an element of a list of " + v.list().at(0).typeName());
            }
            return;
        }
        case Type::Pose:
            if (!element.isNumber()) {
                fault(std::string("Type error: elements of a pose must be numbers, not ") +
                      element.typeName());
            }
            v.pose()[checkedIndex(i, 6)] = element.number();
            return;
        case Type::Matrix: {
            const std::size_t row = checkedIndex(i, v.matrix().rows);
            if (!element.is(Type::List) || !element.list().isNumeric() ||
                element.list().numbers.size() != v.matrix().cols) {
                fault("A row of a matrix must be a list with one number per column");
            }
            MatrixData& m = v.ownMatrix();
            m.integer = m.integer && element.list().kind == ListData::Kind::Int;
            std::copy(element.list().numbers.begin(), element.list().numbers.end(),
                      m.numbers.begin() + static_cast<std::ptrdiff_t>(row * m.cols));
            return;
        }
        default:
            fault(std::string("Type error: ") + v.typeName() + " cannot be indexed");
    }
}

void assignIndexed(Value& v, const Value& row, const Value& column, const Value& element) {
    if (!v.is(Type::Matrix)) {
        fault(std::string("Type error: ") + v.typeName() + " has no rows and columns");
    }
    if (!element.isNumber()) {
        fault(std::string("Type error: elements of a matrix must be numbers, not ") + element.typeName());
    }
    MatrixData& m = v.ownMatrix();
    const std::size_t r = checkedIndex(row, m.rows);
    m.numbers[r * m.cols + checkedIndex(column, m.cols)] = element.number();
    m.integer = m.integer && element.is(Type::Int);
}

}  // namespace tiller::simulator::urscript
