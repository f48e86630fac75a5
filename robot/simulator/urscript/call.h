// SPDX-License-Identifier: MIT
#pragma once

// One call of a builtin function: its arguments, its result and what it does in each frame.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "robot/simulator/urscript/host.h"
#include "robot/simulator/urscript/interpreter.h"
#include "robot/simulator/urscript/value.h"

namespace tiller::simulator::urscript {

/// A runtime exception; the interpreter adds the position.
struct Fault {
    std::string text;
    bool overrun = false;  ///< a thread used too much time without blocking
};
[[noreturn]] void fault(std::string text);
[[noreturn]] void fault(const Error& error);

struct Builtin;
enum class Status {
    Done,
    Again,  ///< not finished: execute again in the next frame
    Line,   ///< interpreter_mode() only: run the next line, then execute again
};

class InterpreterMode;
class RemoteCalls;

/// State shared by all calls of a program.
struct CallContext {
    Host& host;
    const Limits& limits;
    ProgramKind kind = ProgramKind::Main;
    std::int64_t stepNs = 2'000'000;  ///< duration of a frame
    std::uint64_t random = 1;         ///< state of the random number generator
    InterpreterMode* mode = nullptr;
    RemoteCalls* remote = nullptr;
    ThreadId motionOwner = -1;  ///< thread with an unfinished motion command
    bool abortable = false;     ///< the unfinished command is a movej or movel
    int motionVersion = 1;      ///< stored for motion_version_get
    double jerkGain = 1.0;      ///< stored for jerk_gain_scaling_get
};

inline constexpr const char* kTooMuchBehind = "Runtime is too much behind";

/// One call of a builtin. A builtin that is not finished returns Status::Again. It is then executed again
/// with the same arguments, once in every following frame, until it returns Done.
class Call {
public:
    Call(CallContext& context, const Builtin& builtin, ThreadId threadId, std::span<Value> arguments)
        : host(context.host), thread(threadId), args(arguments), context_(context), builtin_(builtin) {}

    Host& host;
    const ThreadId thread;
    const std::span<Value> args;  ///< one value per parameter; Unset if absent
    Value result = Value::none();

    // kept between the executions of a call
    bool first = true;       ///< true in the first execution of the call
    std::int64_t state = 0;  ///< for use by the builtin
    std::int64_t waitedNs = 0;

    // set by the builtin
    std::int64_t consumedNs = 0;  ///< simulated time charged to the thread's slice
    bool endFrame = false;        ///< uses the rest of the slice
    std::int64_t cost = 0;        ///< extra operations, for builtins that process much data
    bool readSocket = false;      ///< data were read; limits the number of reads per frame

    const Limits& limits() const { return context_.limits; }
    std::int64_t stepNs() const { return context_.stepNs; }
    double random();

    const std::string& name() const;
    const char* needs() const;  ///< for absent() builtins: the unavailable equipment
    CallContext& context() { return context_; }

    /// Runs a motion builtin: starts the command in the first execution, then waits for its end.
    template <class MakeCommand>
    Status motion(MakeCommand make) {
        if (first) {
            startMotion(make());
            return Status::Again;
        }
        return motionUnfinished() ? Status::Again : Status::Done;
    }

    // ---- arguments; a wrong type throws a Fault
    bool given(std::size_t i) const { return !args[i].isUnset(); }
    double number(std::size_t i) const;
    double finite(std::size_t i) const;         ///< number that is neither NaN nor infinite
    std::int32_t integer(std::size_t i) const;  ///< int, or a float without fractional part
    int integerIn(std::size_t i, int low, int high) const;
    bool boolean(std::size_t i) const;  ///< bool, or a number (0 is false)
    const std::string& string(std::size_t i) const;
    std::vector<double> numbers(std::size_t i) const;  ///< list or pose
    std::array<double, 6> six(std::size_t i) const;    ///< 6-list or pose
    Eigen::Vector3d three(std::size_t i) const;        ///< list of three
    JointPositions joints(std::size_t i) const;
    Pose pose(std::size_t i) const;          ///< pose only
    Pose poseOr6(std::size_t i) const;       ///< pose or 6-list
    MoveTarget target(std::size_t i) const;  ///< pose or joint list

    [[noreturn]] void badArgument(std::size_t i, const char* expected) const;
    void check(const Result<void>& outcome) const;  ///< an Error becomes a fault

private:
    void startMotion(const MotionCommand& command);
    bool motionUnfinished() const { return context_.motionOwner == thread; }

    CallContext& context_;
    const Builtin& builtin_;
};

/// Throws the fault "<name> needs <equipment>, which is not simulated".
[[noreturn]] Status absent(Call& c);
/// Passes the arguments to SetupHost::applySetting().
Status setting(Call& c);
/// Creates a list of the values of a joint quantity.
Value jointList(const Vector6& values);

}  // namespace tiller::simulator::urscript
