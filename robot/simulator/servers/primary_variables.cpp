// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/primary_variables.h"

#include <algorithm>
#include <functional>

#include "robot/simulator/servers/byte_writer.h"
#include "robot/simulator/urscript/bytecode.h"
#include "robot/simulator/urscript/interpreter.h"

namespace tiller::simulator::primary {

namespace {

using urscript::Value;

constexpr unsigned kProgramState = 25;
enum Kind : unsigned { kSetup = 0, kUpdate = 1 };
enum ValueType : unsigned { kNone = 0, kString = 1, kList = 2, kPose = 3, kBool = 4, kInt = 5, kFloat = 6 };
/// Clients drop packages of 4092 bytes and more.
constexpr std::size_t kLargest = 3000;

/// Cuts a row of items into packages. item  appends the n-th one
std::vector<Bytes> packed(Kind kind, std::size_t count,
                          const std::function<void(std::size_t, Bytes&)>& item) {
    std::vector<Bytes> all;
    Bytes one;
    for (std::size_t i = 0; i < count; ++i) {
        one.clear();
        item(i, one);
        if (all.empty() || all.back().size() + one.size() > kLargest) {
            ByteWriter(all.emplace_back()).u8(kind).u16(static_cast<unsigned>(i));
        }
        one.resize(std::min(one.size(), kLargest));
        all.back().insert(all.back().end(), one.begin(), one.end());
    }
    return all;
}

void appendList(std::size_t count, Bytes& into, const std::function<void(std::size_t)>& element) {
    const std::size_t shown = std::min<std::size_t>(count, 0xFFFF);
    ByteWriter(into).u8(kList).u16(static_cast<unsigned>(shown));
    for (std::size_t i = 0; i < shown && into.size() < kLargest; ++i) {
        element(i);
    }
}

}  // namespace

void appendValue(const Value& value, Bytes& into) {
    ByteWriter out(into);
    switch (value.type()) {
        case Value::Type::Bool:
            out.u8(kBool).flag(value.asBool());
            return;
        case Value::Type::Int:
            out.u8(kInt).i32(value.asInt());
            return;
        case Value::Type::Float:
            out.u8(kFloat).f32(value.asFloat());
            return;
        case Value::Type::Pose:
            out.u8(kPose);
            for (const double number : value.pose()) {
                out.f32(number);
            }
            return;
        case Value::Type::String: {
            const std::string& text = value.string();
            out.u8(kString).u16(static_cast<unsigned>(text.size())).text(text);
            return;
        }
        case Value::Type::List: {
            const urscript::ListData& list = value.list();
            appendList(list.size(), into, [&](std::size_t i) { appendValue(list.at(i), into); });
            return;
        }
        case Value::Type::Matrix: {
            const urscript::MatrixData& matrix = value.matrix();
            appendList(matrix.rows, into, [&](std::size_t row) {
                appendList(matrix.cols, into, [&](std::size_t column) {
                    appendValue(Value(matrix.numbers[row * matrix.cols + column]), into);
                });
            });
            return;
        }
        case Value::Type::Unset:
        case Value::Type::None:
        case Value::Type::Struct:
            out.u8(kNone);
            return;
    }
}

VariableBodies variablesOf(const urscript::Interpreter& program) {
    const std::vector<std::string>& names = program.program().code().globals;
    VariableBodies bodies;
    bodies.names = packed(kSetup, names.size(),
                          [&](std::size_t i, Bytes& into) { ByteWriter(into).text(names[i]).text("\n"); });
    bodies.values = packed(kUpdate, names.size(), [&](std::size_t i, Bytes& into) {
        const Value* value = program.global(names[i]);
        appendValue(value == nullptr ? Value::none() : *value, into);
    });
    return bodies;
}

Bytes variablePackage(std::uint64_t timestampNs, const Bytes& body) {
    Bytes bytes;
    ByteWriter out(bytes);
    const std::size_t length = out.openLength();
    out.u8(kProgramState).u64(timestampNs);
    bytes.insert(bytes.end(), body.begin(), body.end());
    out.closeLength(length);
    return bytes;
}

}  // namespace tiller::simulator::primary
