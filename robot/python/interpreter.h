// SPDX-License-Identifier: MIT
#pragma once

// Handles the Python interpreter lock in blocking calls and in two special situations: the process exits
// while daemon threads are waiting, or a child process is forked, in which the threads of the parent do not
// exist.

#include <pybind11/pybind11.h>

#include <cstdint>

namespace tiller::python {

namespace py = pybind11;

/// Releases the interpreter lock during a call that may wait. Replaces py::gil_scoped_release: with this
/// class, a thread that returns after parkOtherThreads() never enters the interpreter again. Otherwise the
/// interpreter would end the thread by unwinding its stack through destructors, which terminates the process.
class GilReleased {
public:
    GilReleased();
    ~GilReleased();
    GilReleased(const GilReleased&) = delete;
    GilReleased& operator=(const GilReleased&) = delete;

private:
    PyThreadState* thread_;
};

/// Marks this thread as running the callback of a packet loop. The callback runs in the control thread, so
/// calls that may wait for that thread raise InvalidArgument.
class InCallback {
public:
    InCallback();
    ~InCallback();
    InCallback(const InCallback&) = delete;
    InCallback& operator=(const InCallback&) = delete;
};
bool isInCallback();

/// For process exit: cancels all waits of other threads. These threads then sleep until the process ends.
/// Returns when all of them sleep, after 5 s at most. Call this from the exiting thread when only daemon
/// threads remain.
void parkOtherThreads();
/// Returns true if this thread must no longer enter the interpreter.
/// Threads  any, with or without the interpreter lock
bool isParked();
/// For a forked child: discards the waits and objects of the parent.
void forgetParent();
/// Registers parkOtherThreads() and forgetParent() with the interpreter, for modules without a Python part.
/// Call this when the module is initialized.
void watchProcess();

/// Base of objects with threads or connections. These objects belong to the process that created them. A
/// forked child must neither use them (the parent does) nor destroy them (their threads do not exist in the
/// child).
class ProcessOwned {
public:
    ProcessOwned();
    bool isOwn() const;

private:
    std::uint64_t process_;
};

/// Deletes objects of this process and leaves objects of the parent unchanged.
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
