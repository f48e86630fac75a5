// SPDX-License-Identifier: MIT
#pragma once

// What the files of the native module share: errors become exceptions, waits let other Python threads run and
// end on Ctrl-C, numbers cross as arrays.

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
using Seconds = std::optional<double>;  ///< None: without a limit

/// Throws the exception of tiller.errors that stands for this error.
[[noreturn]] void raise(const Error& error);

/// Whether a wait of this thread has to end: on Ctrl-C (the exception is set then), and at the end of the process.
bool isInterrupted();

/// Raises InvalidArgument in a callback of a packet loop, for calls that may wait.
void refuseInCallback();
/// Raises NotConnected for an object of the parent process.
void refuseOfParent(const ProcessOwned& object);

/// The guard of calls that wait without a deadline.
struct WaitingCall {
    WaitingCall() {
        refuseInCallback();
        released_.emplace();
    }

private:
    std::optional<GilReleased> released_;
};

/// value, if it is one of the names of the table; InvalidArgument that lists them otherwise.
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

/// The value of a call that gets a deadline and runs without the interpreter's lock; its error, or Ctrl-C, is
/// thrown.
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

/// The value of a result, or its error thrown.
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

/// The clock everything of a robot goes by: the machine's, or a simulator's own.
using SharedClock = std::shared_ptr<Clock>;

void defineReceive(py::module_& module);
void defineControl(py::module_& module);
void defineSimulator(py::module_& module);
void defineServices(py::module_& module);

}  // namespace tiller::python
