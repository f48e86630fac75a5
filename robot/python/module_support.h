// SPDX-License-Identifier: MIT
#pragma once

// Common functions of all Python modules in this folder. Blocking calls release the interpreter and end on
// Ctrl+C. The keyword names in the listings of the ur_rtde paper are accepted in addition to those of ur_rtde
// 1.5.8. All objects have a docstring, signature and repr, and support `with`.

#include <pybind11/chrono.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <utility>

#include "robot/python/interpreter.h"

namespace tiller::python {

/// For all calls that may wait.
using Unlocked = py::call_guard<GilReleased>;

/// Each module must call this before anything else.
void prepareModule();
/// Each module must call this last. Adds the texts of docstrings.cpp and a signature for inspect.signature()
/// to classes and methods, and __version__ to the module.
void finishModule(py::module_& module);

/// Accepted names of the argument for the robot address.
inline constexpr const char* kHostNames[] = {"hostname", "ip"};

/// An interface that stores its address and process. The holder is OwnHolder or an equivalent type, so that a
/// forked child does not destroy the interface.
template <class Interface>
struct Shown : Interface, ProcessOwned {
    template <class... Arguments>
    explicit Shown(std::string hostname, Arguments&&... arguments)
        : Interface(hostname, std::forward<Arguments>(arguments)...), host(std::move(hostname)) {}
    std::string host;
};

template <class Class>
using OwnHolder = std::unique_ptr<Class, OwnDeleter>;

/// Adds repr() and `with`. `begin` is called at the start of the block, and `end` is always called at its
/// end.
template <class Class, class Begin, class End>
void defineShowing(Class& cls, Begin begin, End end) {
    using Interface = typename Class::type;
    cls.def("__repr__", [](py::object self) {
        auto& interface = self.cast<Interface&>();
        const auto type = py::type::of(self);
        return py::str("<{}.{} {}, {}>")
            .format(type.attr("__module__"), type.attr("__name__"), interface.host,
                    interface.isConnected() ? "connected" : "not connected");
    });
    cls.def("__enter__", [begin](py::object self) {
        auto& interface = self.cast<Interface&>();
        {
            const GilReleased released;
            begin(interface);
        }
        return self;
    });
    cls.def("__exit__", [end](Interface& interface, const py::args&) {
        if (!interface.isOwn()) {
            return;
        }
        const GilReleased released;
        end(interface);
    });
}

/// Defines a motion with speed and acceleration; each of them has two keyword names.
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
