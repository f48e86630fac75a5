// SPDX-License-Identifier: MIT
#pragma once

// The objects of the native module that more than one of its files handles.

#include <atomic>
#include <memory>
#include <utility>

#include "robot/control/controller.h"
#include "robot/core/robot_model.h"
#include "robot/python/native_support.h"
#include "robot/receive/receiver.h"

namespace tiller::python {

/// A receiver with the clock it lives by.
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

/// A controller with the clock it lives by; motions hold on to it. In the process that made it, its end brakes the arm.
struct NativeController : ProcessOwned {
    NativeController(control::ControllerOptions options, SharedClock c)
        : clock(std::move(c)), controller(with(std::move(options), clock)) {}
    ~NativeController() { controller.release(); }

    SharedClock clock;
    control::Controller controller;
    std::atomic<bool> runsLoop{false};  ///< a packet loop is under way

private:
    static control::ControllerOptions with(control::ControllerOptions options, const SharedClock& clock) {
        if (clock) {
            options.clock = clock.get();
        }
        return options;
    }
};

/// InvalidArgument that lists the models is raised for another name.
RobotModelId modelNamed(const std::string& name);

/// Shared, and left alone by a forked child.
template <class T, class... Arguments>
std::shared_ptr<T> sharedOwn(Arguments&&... arguments) {
    return std::shared_ptr<T>(new T(std::forward<Arguments>(arguments)...), OwnDeleter());
}

}  // namespace tiller::python
