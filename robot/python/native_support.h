// SPDX-License-Identifier: MIT
#pragma once

// Common functions of the native module. Errors are raised as exceptions, waits release the interpreter and
// end on Ctrl+C, and numbers are passed as arrays.

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "robot/core/clock.h"
#include "robot/core/deadline.h"
#include "robot/core/joints.h"
#include "robot/core/result.h"
#include "robot/core/spatial.h"
#include "robot/python/interpreter.h"

namespace tiller::python {

using Six = std::array<double, 6>;
using Seconds = std::optional<double>;  ///< None: no limit

/// Raises the exception of tiller.errors for this error.
[[noreturn]] void raise(const Error& error);

/// Returns true if a wait in this thread must end: on Ctrl+C (with the exception set), and when the process
/// exits.
bool isInterrupted();

/// Raises InvalidArgument in the callback of a packet loop. Used by calls that may wait.
void refuseInCallback();
/// Raises NotConnected for an object of the parent process.
void refuseOfParent(const ProcessOwned& object);

/// Guard for calls that wait without a deadline.
struct WaitingCall {
    WaitingCall() {
        refuseInCallback();
        released_.emplace();
    }

private:
    std::optional<GilReleased> released_;
};

/// Looks a name up in the table; raises InvalidArgument with a list of the names if it is unknown.
template <class Value, std::size_t count>
Value named(const char* argument, const std::string& name,
            const std::array<std::pair<const char*, Value>, count>& table) {
    std::string names;
    for (const auto& [known, value] : table) {
        if (name == known) {
            return value;
        }
        names += std::string(names.empty() ? "" : ", ") + '"' + known + '"';
    }
    raise({ErrorCode::InvalidArgument, QString::fromLatin1(argument),
           QStringLiteral("\"%1\" is not one of %2")
               .arg(QString::fromStdString(name), QString::fromStdString(names))});
}

/// Runs a call with a deadline and without the interpreter lock. Returns its value, or raises its error or
/// KeyboardInterrupt.
template <class Call>
auto waited(const Seconds& seconds, Call call) {
    refuseInCallback();
    const CancelToken token([] { return isInterrupted(); });
    const Deadline deadline =
        seconds ? Deadline::after(std::chrono::duration<double>(*seconds), token) : Deadline::never(token);
    auto result = [&] {
        const GilReleased released;
        return call(deadline);
    }();
    if (PyErr_Occurred() != nullptr) {
        throw py::error_already_set();
    }
    if (!result) {
        raise(result.error());
    }
    if constexpr (!std::is_same_v<decltype(result), Result<void>>) {
        return std::move(result).value();
    }
}

/// Returns the value of a result, or raises its error.
template <class T>
T taken(Result<T> result) {
    if (!result) {
        raise(result.error());
    }
    return std::move(result).value();
}
inline void taken(const Result<void>& result) {
    if (!result) {
        raise(result.error());
    }
}

inline Twist twistOf(const Six& v) {
    return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
}
inline Wrench wrenchOf(const Six& v) {
    return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
}

inline py::str string(const QString& text) {
    return py::str(text.toStdString());
}

/// The clock of a robot: the system clock, or the clock of a simulator.
using SharedClock = std::shared_ptr<Clock>;

void defineReceive(py::module_& module);
void defineControl(py::module_& module);
void defineSimulator(py::module_& module);
void defineServices(py::module_& module);
void defineCollision(py::module_& module);
void defineProgram(py::module_& module);

}  // namespace tiller::python
