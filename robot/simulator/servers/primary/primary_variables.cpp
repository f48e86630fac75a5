// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/primary/primary_variables.h"

#include <algorithm>
#include <functional>

#include "robot/simulator/net/byte_writer.h"
#include "robot/simulator/urscript/bytecode.h"
#include "robot/simulator/urscript/interpreter.h"

namespace tiller::simulator::primary {

namespace {

using urscript::Value;

constexpr unsigned kProgramState = 25;
enum Content : unsigned { kSetup = 0, kUpdate = 1 };
enum : unsigned { kNone = 0, kString = 3 };  // identical in all software versions
/// Numbers of the other types, which changed with the introduction of matrices.
struct TypeNumbers {
    unsigned pose, boolean, integer, real, list, matrix;
};
constexpr TypeNumbers kSinceMatrices{12, 13, 15, 16, 17, 18};
constexpr TypeNumbers kBefore{10, 12, 14, 15, 5, kNone};

const TypeNumbers& numbersOf(const SoftwareVersion& software) {
    const bool matrices =
        software >= (software.isCb3() ? SoftwareVersion{3, 14, 0, 0} : SoftwareVersion{5, 9, 0, 0});
    return matrices ? kSinceMatrices : kBefore;
}
/// Maximum package size [bytes]. Clients drop packages of 4092 bytes or more.
constexpr std::size_t kLargest = 3000;
/// Maximum size of one value of any type [bytes].
constexpr std::size_t kLargestValue = 2800;

/// Distributes items over packages.
/// item  appends the item with the given index
std::vector<Bytes> packed(Content kind, std::size_t count,
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

/// Writes consecutive values, each preceded by its type.
class ValueWriter {
public:
    ValueWriter(Bytes& into, const TypeNumbers& numbers) : into_(into), out_(into), types_(numbers) {}

    void write(const Value& value) {
        if (into_.size() >= kLargestValue) {
            out_.u8(kNone);
            return;
        }
        switch (value.type()) {
            case Value::Type::Bool:
                out_.u8(types_.boolean).flag(value.asBool());
                return;
            case Value::Type::Int:
                out_.u8(types_.integer).i32(value.asInt());
                return;
            case Value::Type::Float:
                out_.u8(types_.real).f32(value.asFloat());
                return;
            case Value::Type::Pose:
                out_.u8(types_.pose);
                for (const double number : value.pose()) {
                    out_.f32(number);
                }
                return;
            case Value::Type::String: {
                const std::string_view text = value.string();
                const std::size_t shown = thatFit(text.size(), 1);
                out_.u8(kString).u16(static_cast<unsigned>(shown)).text(text.substr(0, shown));
                return;
            }
            case Value::Type::List:
                writeList(value.list());
                return;
            case Value::Type::Matrix:
                writeMatrix(value.matrix());
                return;
            case Value::Type::Unset:
            case Value::Type::None:
            case Value::Type::Struct:
                out_.u8(kNone);
                return;
        }
    }

private:
    /// Number of elements, with `bytesEach` bytes each, that still fit into kLargestValue. Further elements
    /// are not reported.
    std::size_t thatFit(std::size_t count, std::size_t bytesEach) const {
        const std::size_t room = kLargestValue - std::min(into_.size(), kLargestValue);
        return std::min(count, room / bytesEach);
    }

    void writeList(const urscript::ListData& list) {
        out_.u8(types_.list).u16(0);
        const std::size_t count = into_.size() - 2;
        std::size_t shown = 0;
        for (; shown < list.size() && into_.size() < kLargestValue; ++shown) {
            write(list.at(shown));
        }
        into_[count] = static_cast<std::uint8_t>(shown >> 8);
        into_[count + 1] = static_cast<std::uint8_t>(shown & 0xFF);
    }

    void writeMatrix(const urscript::MatrixData& matrix) {
        constexpr std::size_t kBytes = 5;
        if (types_.matrix == kNone || matrix.cols == 0) {
            out_.u8(kNone);
            return;
        }
        const std::size_t rows = thatFit(matrix.rows, kBytes * matrix.cols);
        out_.u8(types_.matrix).u16(static_cast<unsigned>(rows)).u16(static_cast<unsigned>(matrix.cols));
        for (std::size_t i = 0; i < rows * matrix.cols; ++i) {
            const double number = matrix.numbers[i];
            write(matrix.integer ? Value(static_cast<std::int32_t>(number)) : Value(number));
        }
    }

    Bytes& into_;
    ByteWriter out_;
    const TypeNumbers& types_;
};

}  // namespace

VariableBodies variablesOf(const urscript::Interpreter& program, const SoftwareVersion& software) {
    const std::vector<std::string>& names = program.program().code().globals;
    VariableBodies bodies;
    bodies.names = packed(kSetup, names.size(),
                          [&](std::size_t i, Bytes& into) { ByteWriter(into).text(names[i]).text("\n"); });
    bodies.values = packed(kUpdate, names.size(), [&](std::size_t i, Bytes& into) {
        const Value* value = program.global(names[i]);
        ValueWriter(into, numbersOf(software)).write(value == nullptr ? Value::none() : *value);
        ByteWriter(into).text("\n");
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
