// SPDX-License-Identifier: MIT
#include "robot/simulator/urscript/call.h"

#include <cmath>
#include <limits>

#include "robot/simulator/urscript/builtin_table.h"

namespace tiller::simulator::urscript {

void fault(std::string text) {
    throw Fault{std::move(text)};
}

void fault(const Error& error) {
    const QString& text = error.controllerMessage.isEmpty() ? error.context : error.controllerMessage;
    throw Fault{text.toStdString()};
}

Status absent(Call& c) {
    fault(c.name() + " needs " + c.needs() + ", which is not simulated");
}

Status setting(Call& c) {
    std::vector<double> values;
    for (const Value& v : c.args) {
        if (v.isNumber() || v.is(Value::Type::Bool)) {
            values.push_back(v.isNumber() ? v.number() : v.asBool() ? 1.0 : 0.0);
        } else if (v.is(Value::Type::Pose)) {
            values.insert(values.end(), v.pose().begin(), v.pose().end());
        }
    }
    c.check(c.host.applySetting(c.name(), values));
    return Status::Done;
}

Value jointList(const Vector6& values) {
    return Value::floats(values.data(), 6);
}

const std::string& Call::name() const {
    return builtin_.name;
}

const char* Call::needs() const {
    return builtin_.needs;
}

double Call::random() {
    // splitmix64. For the same seed, it generates the same numbers on every machine.
    std::uint64_t z = (context_.random += 0x9E3779B97F4A7C15ULL);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-53;
}

void Call::startMotion(const MotionCommand& command) {
    if (context_.kind == ProgramKind::Secondary) {
        fault(kTooMuchBehind);
    }
    if (context_.motionOwner >= 0 && context_.motionOwner != thread) {
        fault("Another thread is already controlling the robot");
    }
    check(host.startMotion(thread, command));
    context_.motionOwner = thread;
    const Move* move = std::get_if<Move>(&command);
    context_.abortable = move != nullptr && (move->kind == Move::Kind::J || move->kind == Move::Kind::L);
}

void Call::badArgument(std::size_t i, const char* expected) const {
    const std::string name =
        i < builtin_.parameters.size() ? "'" + builtin_.parameters[i].name + "'" : std::to_string(i + 1);
    fault("Type error: " + builtin_.name + " argument " + name + " must be " + expected + ", not " +
          args[i].typeName());
}

void Call::check(const Result<void>& outcome) const {
    if (!outcome.ok()) {
        fault(outcome.error());
    }
}

double Call::number(std::size_t i) const {
    if (!args[i].isNumber()) {
        badArgument(i, "a number");
    }
    return args[i].number();
}

double Call::finite(std::size_t i) const {
    const double d = number(i);
    if (!std::isfinite(d)) {
        badArgument(i, "a finite number");
    }
    return d;
}

std::int32_t Call::integer(std::size_t i) const {
    if (args[i].is(Value::Type::Int)) {
        return args[i].asInt();
    }
    if (args[i].is(Value::Type::Float)) {
        const double d = args[i].asFloat();
        // Clients that calculate an integer by division pass 2.0 instead of 2.
        if (d == std::floor(d) && std::abs(d) <= std::numeric_limits<std::int32_t>::max()) {
            return static_cast<std::int32_t>(d);
        }
    }
    badArgument(i, "an integer");
}

int Call::integerIn(std::size_t i, int low, int high) const {
    const std::int32_t value = integer(i);
    if (value < low || value > high) {
        fault("Range error: " + builtin_.name + " argument '" + builtin_.parameters[i].name + "' is " +
              std::to_string(value) + ", allowed is " + std::to_string(low) + " to " + std::to_string(high));
    }
    return value;
}

bool Call::boolean(std::size_t i) const {
    if (args[i].is(Value::Type::Bool)) {
        return args[i].asBool();
    }
    if (args[i].isNumber()) {
        return args[i].number() != 0;
    }
    badArgument(i, "a bool");
}

const std::string& Call::string(std::size_t i) const {
    if (!args[i].is(Value::Type::String)) {
        badArgument(i, "a string");
    }
    return args[i].string();
}

std::vector<double> Call::numbers(std::size_t i) const {
    if (args[i].is(Value::Type::Pose)) {
        return {args[i].pose().begin(), args[i].pose().end()};
    }
    if (args[i].is(Value::Type::List) && args[i].list().kind != ListData::Kind::Other) {
        return args[i].list().numbers;
    }
    badArgument(i, "a list of numbers");
}

std::array<double, 6> Call::six(std::size_t i) const {
    if (args[i].is(Value::Type::Pose)) {
        return args[i].pose();
    }
    if (args[i].is(Value::Type::List) && args[i].list().numbers.size() == 6) {
        std::array<double, 6> out;
        std::copy_n(args[i].list().numbers.begin(), 6, out.begin());
        return out;
    }
    badArgument(i, "a list of six numbers");
}

Eigen::Vector3d Call::three(std::size_t i) const {
    if (args[i].is(Value::Type::List) && args[i].list().numbers.size() == 3) {
        return Eigen::Vector3d(args[i].list().numbers.data());
    }
    badArgument(i, "a list of three numbers");
}

JointPositions Call::joints(std::size_t i) const {
    const JointPositions q(six(i));
    if (!q.allFinite()) {
        badArgument(i, "a list of six finite numbers");
    }
    return q;
}

Pose Call::pose(std::size_t i) const {
    if (!args[i].is(Value::Type::Pose)) {
        badArgument(i, "a pose");
    }
    return Pose::fromArray(args[i].pose());
}

Pose Call::poseOr6(std::size_t i) const {
    return Pose::fromArray(six(i));
}

MoveTarget Call::target(std::size_t i) const {
    if (args[i].is(Value::Type::Pose)) {
        const Pose target = pose(i);
        if (!target.allFinite()) {
            badArgument(i, "a pose of finite numbers");
        }
        return target;
    }
    if (args[i].is(Value::Type::List)) {
        return joints(i);
    }
    badArgument(i, "a pose or a list of joint positions");
}

}  // namespace tiller::simulator::urscript
