// SPDX-License-Identifier: MIT
// Lists and matrices.

#include <Eigen/Dense>
#include <cmath>

#include "robot/simulator/urscript/builtin_table.h"
#include "robot/simulator/urscript/call.h"

namespace tiller::simulator::urscript {

namespace {

using Type = Value::Type;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Matrix inversion has cubic cost, but a frame has only two milliseconds.
constexpr std::size_t kMaxInverse = 32;

Status norm(Call& c) {
    if (c.args[0].isNumber()) {
        c.result = std::abs(c.args[0].number());
        return Status::Done;
    }
    double sum = 0;
    for (const double d : c.numbers(0)) {
        sum += d * d;
    }
    c.result = std::sqrt(sum);
    return Status::Done;
}

Status normalize(Call& c) {
    std::vector<double> v = c.numbers(0);
    double sum = 0;
    for (const double d : v) {
        sum += d * d;
    }
    if (!(sum > 0)) {
        fault("normalize: the length of the vector is zero");
    }
    for (double& d : v) {
        d /= std::sqrt(sum);
    }
    c.result = Value::floats(v.data(), v.size());
    return Status::Done;
}

std::int32_t lengthOf(const Call& c) {
    switch (c.args[0].type()) {
        case Type::List:
            return static_cast<std::int32_t>(c.args[0].list().size());
        case Type::Matrix:
            return static_cast<std::int32_t>(c.args[0].matrix().rows);
        case Type::String:
            return static_cast<std::int32_t>(c.args[0].string().size());
        case Type::Pose:
            return 6;
        default:
            c.badArgument(0, "a list or a string");
    }
}

Status length(Call& c) {
    c.result = lengthOf(c);
    return Status::Done;
}

Status size(Call& c) {
    if (c.args[0].is(Type::Matrix)) {
        const MatrixData& m = c.args[0].matrix();
        const std::int32_t both[] = {static_cast<std::int32_t>(m.rows), static_cast<std::int32_t>(m.cols)};
        c.result = Value::ints(both, 2);
    } else {
        c.result = lengthOf(c);
    }
    return Status::Done;
}

Status makeList(Call& c) {
    const std::int32_t count = c.integer(0);
    const std::int32_t capacity = c.given(2) ? c.integer(2) : count;
    if (count < 0 || capacity < count || static_cast<std::size_t>(capacity) > c.limits().listLength) {
        fault("make_list: length and capacity must be from 0 to " + std::to_string(c.limits().listLength) +
              ", length not above capacity");
    }
    ListData data;
    if (!data.accepts(c.args[1])) {
        c.badArgument(1, "a bool, number, string, pose or struct");
    }
    std::size_t budget = c.limits().listLength;
    for (std::int32_t i = 0; i < count; ++i) {
        if (!c.args[1].withinBounds(kMaxValueDepth - 1, budget)) {
            fault("make_list: the list would be too large");
        }
        data.insert(data.size(), c.args[1]);
    }
    data.capacity = static_cast<std::size_t>(capacity);
    c.result = Value::list(std::move(data));
    c.cost = count / 4;
    return Status::Done;
}

Status inv(Call& c) {
    if (c.args[0].is(Type::Pose)) {
        c.result = Pose(c.pose(0).transform().inverse());
        return Status::Done;
    }
    if (!c.args[0].is(Type::Matrix)) {
        c.badArgument(0, "a square matrix or a pose");
    }
    const MatrixData& m = c.args[0].matrix();
    if (m.rows != m.cols || m.rows > kMaxInverse) {
        fault("inv: the matrix must be square, with a maximum size of 32x32");
    }
    const auto n = static_cast<Eigen::Index>(m.rows);
    const Eigen::FullPivLU<RowMajor> lu(Eigen::Map<const RowMajor>(m.numbers.data(), n, n));
    if (!lu.isInvertible()) {
        fault("inv: the matrix is singular");
    }
    const RowMajor inverse = lu.inverse();
    MatrixData out;
    out.rows = out.cols = m.rows;
    out.integer = false;
    out.numbers.assign(inverse.data(), inverse.data() + inverse.size());
    c.result = Value::matrix(std::move(out));
    c.cost = static_cast<std::int64_t>(m.rows * m.rows * m.rows);
    return Status::Done;
}

Status transpose(Call& c) {
    if (!c.args[0].is(Type::Matrix)) {
        c.badArgument(0, "a matrix");
    }
    const MatrixData& m = c.args[0].matrix();
    MatrixData out;
    out.rows = m.cols;
    out.cols = m.rows;
    out.integer = m.integer;
    for (std::size_t col = 0; col < m.cols; ++col) {
        for (std::size_t row = 0; row < m.rows; ++row) {
            out.numbers.push_back(m.numbers[row * m.cols + col]);
        }
    }
    c.cost = static_cast<std::int64_t>(out.numbers.size() / 4);
    c.result = Value::matrix(std::move(out));
    return Status::Done;
}

// Index 0 is the least significant bit. 32 bits result in a signed number.
Status binaryListToInteger(Call& c) {
    const Value& v = c.args[0];
    if (!v.is(Type::List) || (v.list().kind != ListData::Kind::Bool && v.list().size() != 0)) {
        c.badArgument(0, "a list of bools");
    }
    const std::vector<double>& bits = v.list().numbers;
    if (bits.size() > 32) {
        fault("binary_list_to_integer: more than 32 bits");
    }
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < bits.size(); ++i) {
        number |= bits[i] != 0 ? 1u << i : 0u;
    }
    c.result = static_cast<std::int32_t>(number);
    return Status::Done;
}

Status integerToBinaryList(Call& c) {
    const auto number = static_cast<std::uint32_t>(c.integer(0));
    ListData data;
    data.kind = ListData::Kind::Bool;
    for (unsigned i = 0; i < 32; ++i) {
        data.numbers.push_back((number >> i) & 1u ? 1.0 : 0.0);
    }
    c.result = Value::list(std::move(data));
    return Status::Done;
}

constexpr BuiltinRow kListRows[] = {
    {"norm(a)", norm},
    {"normalize(v)", normalize, kPlain, kAfter33},
    {"get_list_length(v)", length},
    {"length(v)", length},
    {"size(v)", size, kPlain, kAfter2019},
    {"make_list(length, initial_value, capacity?)", makeList, kPlain, {{15}}},
    {"inv(m)", inv, kPlain, kAfter2019},
    {"transpose(m)", transpose, kPlain, kAfter2019},
    {"binary_list_to_integer(l)", binaryListToInteger},
    {"integer_to_binary_list(x)", integerToBinaryList},
};

}  // namespace

std::span<const BuiltinRow> listBuiltins() {
    return kListRows;
}

}  // namespace tiller::simulator::urscript
