// SPDX-License-Identifier: MIT
#pragma once

// For the files that make up RTDEReceiveInterface only.

#include <mutex>
#include <string_view>

#include "robot/receive/receiver.h"
#include "robot/recording/recorder.h"
#include "robot/ur_rtde/rtde_receive_interface.h"

struct ur_rtde::RTDEReceiveInterface::Private {
    explicit Private(tiller::receive::ReceiverOptions options) : receiver(std::move(options)) {}

    tiller::receive::Receiver receiver;
    tiller::recording::Recorder recorder;
    bool verbose = false;
    double givenPeriod = 0;  ///< [s]; 0: the controller's own

    std::mutex mutex;  ///< of starting and stopping
    std::mutex pausing;
    PausingState state = PausingState::RUNNING;
    double resumedAt = 0;  ///< `timestamp` when the program went on after a pause [s]

    /// The newest package, in a copy of the calling thread's own.
    const tiller::receive::Sample& newest() const;
    std::vector<double> list(std::string_view field) const;
    double number(std::string_view field) const;
    double registerValue(const std::string& field) const;
    double speed();
    /// Starts and waits for the first package. The receiver goes on trying when none came.
    void start();
    bool waitForPackage(std::chrono::milliseconds atMost);
};
