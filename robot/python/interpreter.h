// SPDX-License-Identifier: MIT
#pragma once

// How calls that wait share the interpreter with other Python threads, and how they behave at its two ends: when the
// process exits while daemon threads wait, and in a forked child, where the threads of the parent do not exist.

#include <pybind11/pybind11.h>

#include <cstdint>

namespace tiller::python {

namespace py = pybind11;

/// Lets other Python threads run during a call that may wait. Replaces py::gil_scoped_release: a thread that comes back
/// after parkOtherThreads() never touches the interpreter again. There the interpreter would end it by unwinding its stack
/// through destructors, which terminates the process.
class GilReleased {
public:
    GilReleased();
    ~GilReleased();
    GilReleased(const GilReleased&) = delete;
    GilReleased& operator=(const GilReleased&) = delete;

private:
    PyThreadState* thread_;
};

/// As GilReleased, for a call that may wait for what the control thread does. A packet loop's callback, which runs in the
/// control thread, must not make such a call: InvalidArgument is raised there.
/// While it lives this thread runs a packet loop's callback.
class InCallback {
public:
    InCallback();
    ~InCallback();
    InCallback(const InCallback&) = delete;
    InCallback& operator=(const InCallback&) = delete;
};
bool isInCallback();

/// The process exits: every wait of another thread is cancelled, and its thread sleeps until the end. Returns when all
/// sleep, after 5 s at most. To be called by the thread that exits, when only daemon threads are left.
void parkOtherThreads();
/// Whether this thread must not enter the interpreter any more.
/// Threads  any, with or without the lock of the interpreter
bool isParked();
/// In a forked child: no thread of the parent waits, and its objects are not ours.
void forgetParent();
/// Registers both with the interpreter, for modules without a Python part. To be called by the module's initialization.
void watchProcess();

/// Of an object with threads or connections: they belong to the process that made it. A forked child must neither use them
/// (the parent does) nor end them (its threads do not exist).
class ProcessOwned {
public:
    ProcessOwned();
    bool isOwn() const;

private:
    std::uint64_t process_;
};

/// Deletes what this process made and leaves alone what its parent made.
struct OwnDeleter {
    template <class T>
    void operator()(T* object) const {
        if (!object->isOwn()) {
            return;
        }
        if (PyGILState_Check() == 1) {
            const GilReleased released;
            delete object;
        } else {
            delete object;
        }
    }
};

}  // namespace tiller::python
