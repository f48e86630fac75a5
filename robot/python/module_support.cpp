// SPDX-License-Identifier: MIT
#include "robot/python/module_support.h"

#include "robot/ur_rtde/waiting.h"

namespace tiller::python {

namespace {

// Python handles signals in its main thread only, and only when asked; what it found is raised already then.
bool userLostPatience() {
    const py::gil_scoped_acquire locked;
    return PyErr_CheckSignals() != 0;
}

}  // namespace

void prepareModule() {
    urrtde::setInterruptCheck(&userLostPatience);
    py::register_local_exception_translator([](std::exception_ptr thrown) {
        try {
            std::rethrow_exception(thrown);
        } catch (const urrtde::Interrupted&) {
            if (PyErr_Occurred() == nullptr) {
                PyErr_SetNone(PyExc_KeyboardInterrupt);
            }
        }
    });
}

}  // namespace tiller::python
