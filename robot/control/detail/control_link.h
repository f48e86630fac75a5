// SPDX-License-Identifier: MIT
#pragma once

// The control thread and its RTDE connection: claims the registers, passes each packet from the robot to the
// ControlLoop and sends the resulting command.

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "robot/control/controller.h"
#include "robot/control/detail/control_loop.h"
#include "robot/control/detail/registers.h"
#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "robot/platform/native_socket.h"
#include "robot/realtime/triple_buffer.h"
#include "robot/receive/sample.h"
#include "robot/rtde/connection.h"
#include "robot/script/primary_client.h"

namespace tiller::control {

/// Owns the thread "control", with the priority from the options.
/// Threads  open() to end(): one at a time. checkModes() and findProgram(): between open() and begin(). All
///          others: any
class ControlLink {
public:
    ControlLink(const ControllerOptions& options, ControlLoop& loop) : options_(options), loop_(loop) {}
    ~ControlLink() { end(); }
    ControlLink(const ControlLink&) = delete;
    ControlLink& operator=(const ControlLink&) = delete;

    /// Connects and claims the registers.
    /// Errors  those of rtde::Connection::open(), RegisterInUse and FieldUnknown with a suggested action
    Result<void> open(const Deadline& deadline);
    /// Errors  UnsafeState if the arm is not ready to move, Timeout, Cancelled
    Result<void> checkModes(const Deadline& deadline);
    /// Reads the echo of the running program.
    /// Errors  NotInControl if it is not a control program, Timeout, Cancelled
    Result<Echo> findProgram(const Deadline& deadline);
    SoftwareVersion version() const { return connection_->version(); }
    /// Period of the data stream [s].
    double period() const { return connection_->period(); }

    /// Starts the thread.
    /// primary  used to stop a paused program; must outlive the thread
    void begin(script::PrimaryClient& primary);
    /// Ends the thread and closes the connection. No effect if neither exists.
    void end();
    std::uint16_t localPort() const { return localPort_.load(std::memory_order_acquire); }
    bool isRunning() const { return running_.load(std::memory_order_acquire); }

    /// Makes the control thread send the newest command at once, unless the clock is virtual.
    void wake() const {
        if (options_.clock->runsByItself()) {
            waker_.wake();
        }
    }
    /// Writes the watchdog register once.
    /// Errors  NotInControl; RegisterInUse if another client uses the register
    Result<void> kickWatchdog();
    /// wrench  [N, Nm]
    /// Errors  NotInControl; RegisterInUse if the input is missing or another client uses it
    Result<void> sendWrench(const std::array<double, 6>& wrench);

private:
    Result<Feedback> firstData(const Deadline& deadline, const QString& context);
    void run(script::PrimaryClient& primary);
    void planSample(const std::vector<std::string>& names);
    Feedback decode(std::span<const double> values);
    Feedback newest(std::vector<double>& values, std::int64_t lookedNs, std::int64_t doneNs);
    bool send(const Command& command);
    std::int64_t now() const { return options_.clock->nowNs(); }

    const ControllerOptions& options_;
    ControlLoop& loop_;
    std::unique_ptr<rtde::Connection> connection_;  ///< used by the control thread while it runs
    FeedbackLayout layout_;
    receive::Sample sample_;           ///< the newest packet
    std::vector<std::size_t> places_;  ///< sample index of each value of a packet
    std::thread thread_;
    std::atomic<bool> quit_{false};
    std::atomic<bool> running_{false};
    std::atomic<std::uint16_t> localPort_{0};
    native_socket::EventFd waker_;
    std::atomic<bool> watchdogUsable_{false};
    std::atomic<bool> wrenchUsable_{false};
    std::atomic<bool> kick_{false};
    std::mutex wrenchCallers_;
    realtime::TripleBuffer<std::array<double, 6>> wrench_;
};

}  // namespace tiller::control
