// SPDX-License-Identifier: MIT
#pragma once

// What all Python modules of this room share: calls that wait let other Python threads run and end on Ctrl-C,
// and the keywords of the paper's listings are understood beside the released ones.

#include <pybind11/chrono.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

namespace tiller::python {

namespace py = pybind11;

/// For every call that may wait.
using Unlocked = py::call_guard<py::gil_scoped_release>;

/// To be called once by each module.
void prepareModule();

/// The robot's address has two names.
inline constexpr const char* kHostNames[] = {"hostname", "ip"};

/// A motion with speed and acceleration, which have two names each.
template <class Class, class Function>
void defineMove(Class& cls, const char* name, Function function, const char* target, double speed,
                double acceleration) {
    for (const char* v : {"speed", "vel"}) {
        for (const char* a : {"acceleration", "acc"}) {
            cls.def(name, function, py::arg(target), py::arg(v) = speed, py::arg(a) = acceleration,
                    py::arg("asynchronous") = false, Unlocked());
        }
    }
}

}  // namespace tiller::python
