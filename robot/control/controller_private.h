// SPDX-License-Identifier: MIT
#pragma once

// The inside of Controller: the control thread and the way into control. For controller.cpp and
// take_control.cpp only.

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include "robot/control/control_loop.h"
#include "robot/control/controller.h"
#include "robot/control/mailbox.h"
#include "robot/control/registers.h"
#include "robot/rtde/connection.h"
#include "robot/script/primary_client.h"

namespace tiller::control {

struct Controller::Private {
    explicit Private(const ControllerOptions& o) : options(o), loop(mailbox, o.limits) {}

    ControllerOptions options;
    Mailbox mailbox;
    ControlLoop loop;

    std::mutex taking;  ///< takeControl() and release() one after the other

    std::unique_ptr<rtde::Connection> connection;  ///< the control thread's while it runs
    FeedbackLayout layout;
    std::thread thread;
    std::atomic<bool> quit{false};
    std::atomic<bool> running{false};

    mutable std::mutex arm;  ///< of the two below
    SoftwareVersion version;
    ArmLimits armLimits;

    int primaryPort() const {
        return options.primaryPort != 0 ? options.primaryPort : 30001 + options.portOffset;
    }
    int rtdePort() const { return options.rtdePort != 0 ? options.rtdePort : 30004 + options.portOffset; }
    std::int64_t now() const { return options.clock->nowNs(); }

    // take_control.cpp
    Result<void> take(const Deadline& deadline);
    Result<void> openRegisters(const Deadline& deadline);
    Result<void> checkModes(const Deadline& deadline);
    Result<void> upload(std::int32_t session, script::PrimaryClient& primary, const Deadline& deadline);
    void startThread(std::int32_t session, const ArmLimits& limits);
    void stopThread();

    // controller.cpp
    void run();
    /// Why no motion may begin now; code None when it may.
    Error obstacle(const QString& context) const;
};

}  // namespace tiller::control
