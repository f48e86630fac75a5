// SPDX-License-Identifier: MIT
#pragma once

// Objects used in several files of the native module.

#include <atomic>
#include <memory>
#include <mutex>
#include <utility>

#include "robot/control/controller.h"
#include "robot/core/robot_model.h"
#include "robot/python/native_support.h"
#include "robot/receive/receiver.h"
#include "robot/station/program/execution/program_execution.h"

namespace tiller::python {

/// A receiver and its clock.
struct NativeReceiver : ProcessOwned {
    NativeReceiver(receive::ReceiverOptions options, SharedClock c)
        : clock(std::move(c)), receiver(with(std::move(options), clock)) {}

    SharedClock clock;
    receive::Receiver receiver;

private:
    static receive::ReceiverOptions with(receive::ReceiverOptions options, const SharedClock& clock) {
        if (clock) {
            options.clock = clock.get();
        }
        return options;
    }
};

/// A controller and its clock. Motions keep the controller alive. Destroying the controller stops the arm,
/// except in a forked child.
struct NativeController : ProcessOwned {
    NativeController(control::ControllerOptions options, SharedClock c)
        : clock(std::move(c)), controller(with(std::move(options), clock)) {}
    ~NativeController() {
        run_.reset();
        controller.release();
    }

    /// The last started program; null if there is none. It continues without its handle.
    std::shared_ptr<program::ProgramExecution> run() const {
        const std::lock_guard lock(mutex_);
        return run_;
    }
    void setRun(std::shared_ptr<program::ProgramExecution> run) {
        const std::lock_guard lock(mutex_);
        run_ = std::move(run);
    }

    /// Ends the program, if one is running, and releases control.
    void release() {
        if (const auto running = run()) {
            constexpr std::chrono::seconds kLimit(5);
            running->stop();
            (void)running->wait(Deadline::after(kLimit));
        }
        controller.release();
    }

    SharedClock clock;
    control::Controller controller;
    std::atomic<bool> runsLoop{false};  ///< a packet loop is running

private:
    static control::ControllerOptions with(control::ControllerOptions options, const SharedClock& clock) {
        if (clock) {
            options.clock = clock.get();
        }
        return options;
    }

    mutable std::mutex mutex_;
    std::shared_ptr<program::ProgramExecution> run_;
};

using ControllerClass = py::class_<NativeController, std::shared_ptr<NativeController>>;
/// Defines the settings, queries and output pulses.
void defineSetup(ControllerClass& cls);

/// Raises InvalidArgument with a list of the models if the name is unknown.
RobotModelId modelNamed(const std::string& name);

/// Creates a shared object that is not destroyed in a forked child.
template <class T, class... Arguments>
std::shared_ptr<T> sharedOwn(Arguments&&... arguments) {
    return std::shared_ptr<T>(new T(std::forward<Arguments>(arguments)...), OwnDeleter());
}

}  // namespace tiller::python
