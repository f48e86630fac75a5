// SPDX-License-Identifier: MIT
#include "robot/python/interpreter.h"

#include <atomic>
#include <chrono>
#include <thread>

namespace tiller::python {

namespace {

using namespace std::chrono_literals;

std::atomic<bool> isExiting{false};
std::atomic<int> callsUnderWay{0};
std::atomic<std::uint64_t> processNumber{1};
std::atomic<std::thread::id> exitingThread{};
thread_local bool runsCallback = false;

[[noreturn]] void sleepUntilTheEnd() {
    callsUnderWay.fetch_sub(1);
    for (;;) {
        std::this_thread::sleep_for(1h);
    }
}

}  // namespace

bool isParked() {
    return isExiting.load() && exitingThread.load() != std::this_thread::get_id();
}

GilReleased::GilReleased() {
    callsUnderWay.fetch_add(1);
    thread_ = PyEval_SaveThread();
    if (isParked()) {
        sleepUntilTheEnd();
    }
}

// Threads that pass this check still acquire the lock. parkOtherThreads() waits for these threads without
// holding the lock.
GilReleased::~GilReleased() {
    if (isParked()) {
        sleepUntilTheEnd();
    }
    PyEval_RestoreThread(thread_);
    callsUnderWay.fetch_sub(1);
}

InCallback::InCallback() {
    runsCallback = true;
}

InCallback::~InCallback() {
    runsCallback = false;
}

bool isInCallback() {
    return runsCallback;
}

void parkOtherThreads() {
    exitingThread = std::this_thread::get_id();
    isExiting = true;
    PyThreadState* const thread = PyEval_SaveThread();
    const auto end = std::chrono::steady_clock::now() + 5s;
    while (callsUnderWay.load() > 0 && std::chrono::steady_clock::now() < end) {
        std::this_thread::sleep_for(1ms);
    }
    PyEval_RestoreThread(thread);
}

void forgetParent() {
    callsUnderWay = 0;
    isExiting = false;
    processNumber.fetch_add(1);
}

void watchProcess() {
    py::module_::import("atexit").attr("register")(py::cpp_function(&parkOtherThreads));
    const py::module_ os = py::module_::import("os");
    if (py::hasattr(os, "register_at_fork")) {
        os.attr("register_at_fork")(py::arg("after_in_child") = py::cpp_function(&forgetParent));
    }
}

ProcessOwned::ProcessOwned() : process_(processNumber.load()) {}

bool ProcessOwned::isOwn() const {
    return process_ == processNumber.load();
}

}  // namespace tiller::python
