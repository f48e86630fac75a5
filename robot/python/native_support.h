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

namespace tiller::python {

namespace py = pybind11;

using Six = std::array<double, 6>;
using Seconds = std::optional<double>;  ///< None: without a limit

/// Throws the exception of tiller.errors that stands for this error.
[[noreturn]] void raise(const Error& error);

/// Whether Python has something to tell this thread (Ctrl-C); the exception is set then.
bool isInterrupted();

/// The value of a call that gets a deadline and runs without the interpreter's lock; its error, or Ctrl-C, is
/// thrown.
template <class Call>
auto waited(const Seconds& seconds, Call call) {
    const CancelToken token([] { return isInterrupted(); });
    const Deadline deadline =
        seconds ? Deadline::after(std::chrono::duration<double>(*seconds), token) : Deadline::never(token);
    auto result = [&] {
        const py::gil_scoped_release released;
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
