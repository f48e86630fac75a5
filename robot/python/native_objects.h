// SPDX-License-Identifier: MIT
#pragma once

// The objects of the native module that more than one of its files handles.

#include <memory>
#include <utility>

#include "robot/control/controller.h"
#include "robot/python/native_support.h"
#include "robot/receive/receiver.h"

namespace tiller::python {

/// A receiver with the clock it lives by.
struct NativeReceiver {
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

/// A controller with the clock it lives by; motions hold on to it.
struct NativeController {
    NativeController(control::ControllerOptions options, SharedClock c)
        : clock(std::move(c)), controller(with(std::move(options), clock)) {}
    ~NativeController() { controller.release(); }

    SharedClock clock;
    control::Controller controller;

private:
    static control::ControllerOptions with(control::ControllerOptions options, const SharedClock& clock) {
        if (clock) {
            options.clock = clock.get();
        }
        return options;
    }
};

}  // namespace tiller::python
