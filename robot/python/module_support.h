// SPDX-License-Identifier: MIT
#pragma once

// What all Python modules of this room share: calls that wait let other Python threads run and end on Ctrl-C,
// the keywords of the paper's listings are understood beside the released ones, and every object explains
// itself: docstring, signature, repr, `with`.

#include <pybind11/chrono.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <utility>

#include "robot/python/interpreter.h"

namespace tiller::python {

/// For every call that may wait.
using Unlocked = py::call_guard<GilReleased>;

/// To be called first by each module.
void prepareModule();
/// To be called last: gives classes and methods the texts of docstrings.cpp and a signature that
/// inspect.signature() understands, and the module its __version__.
void finishModule(py::module_& module);

/// The robot's address has two names.
inline constexpr const char* kHostNames[] = {"hostname", "ip"};

/// An interface that knows whom it was made for, and in which process. Held by OwnHolder or with the same rule: a forked
/// child leaves it alone.
template <class Interface>
struct Shown : Interface, ProcessOwned {
    template <class... Arguments>
    explicit Shown(std::string hostname, Arguments&&... arguments)
        : Interface(hostname, std::forward<Arguments>(arguments)...), host(std::move(hostname)) {}
    std::string host;
};

template <class Class>
using OwnHolder = std::unique_ptr<Class, OwnDeleter>;

/// repr(), and `with`: `begin` is called at its beginning, `end` at its end, whatever happened between.
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
