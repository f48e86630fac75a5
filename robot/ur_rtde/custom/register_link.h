// SPDX-License-Identifier: MIT
#pragma once

// The RTDE connection to a user program with ur_rtde's registers: the state of the program, and the recipes
// for commands. Private to robot/ur_rtde.

#include <QString>
#include <array>
#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "robot/core/modes.h"
#include "robot/core/result.h"
#include "robot/rtde/connection.h"
#include "robot/ur_rtde/detail/control_backend.h"

namespace tiller::urrtde {

struct RegisterLinkOptions {
    QString host;
    double frequency = 0;  ///< 0: default of the controller
    int offset = 0;        ///< first register of the range: 0 or 24
    int priority = 0;
};

/// Values of one packet from the robot.
struct RegisterState {
    std::uint64_t sequence = 0;  ///< 0: no packet yet
    std::uint64_t played = 0;    ///< number of packets that reported a running program
    std::uint32_t robotStatus = 0;
    std::uint32_t safetyStatus = 0;
    RuntimeState runtime = RuntimeState::Stopped;
    int answer = 0;    ///< program state: 0 busy, 1 ready, 2 done
    int answered = 0;  ///< number of the completed command; 0: not reported
    int result = 0;    ///< result of the command
    int progress = 0;  ///< see AsyncOperationStatus
    std::array<double, 6> values{};

    bool isDone(int command) const { return answer == 2 && (answered == 0 || answered == command); }
    bool isPlaying() const { return runtime == RuntimeState::Playing; }
    bool hasEnded() const { return runtime == RuntimeState::Stopped || runtime == RuntimeState::Stopping; }
    /// True in a protective or emergency stop.
    bool isStopped() const { return (safetyStatus & ((1U << 2) | (1U << 7))) != 0; }
};

/// Owns one thread, "ur_rtde-control", with the priority in the options. open() starts it; close() and the
/// destructor end it within 50 ms. The thread reads the packets and notifies waiting threads.
class RegisterLink {
public:
    /// Errors   as for rtde::Connection::open(); FieldUnknown if the robot does not have these registers
    static Result<std::unique_ptr<RegisterLink>> open(const RegisterLinkOptions& options,
                                                      const Deadline& deadline);
    ~RegisterLink();
    RegisterLink(const RegisterLink&) = delete;
    RegisterLink& operator=(const RegisterLink&) = delete;

    // Threads of all following functions: any.

    void close();
    bool isAlive() const { return alive_; }
    SoftwareVersion version() const { return version_; }
    RegisterState state() const;
    /// Waits until `done` returns true for a packet, or until `giveUp` returns true. Several packets may be
    /// evaluated together, so the state must contain a counter for short events.
    /// Returns  the last result of `done`
    bool wait(const std::function<bool(const RegisterState&)>& done,
              const std::function<bool(const RegisterState&)>& giveUp, std::chrono::milliseconds atMost);
    /// Makes waiting threads evaluate their conditions again.
    void wake() { changed_.notify_all(); }

    /// Sends a command to the robot through the input registers of a recipe.
    /// recipe  1 ... 20
    /// values  in the order of the recipe, starting with the command
    /// Returns  false if the command cannot be sent to the robot
    bool send(int recipe, const std::vector<double>& values);
    /// Sends "no command".
    bool clear();
    /// Sends "no command" only if `command` is still the last command sent.
    bool clear(CommandId command);
    /// Returns true if this is the last command sent.
    bool holds(CommandId command) const { return command_ == static_cast<int>(command); }
    /// Sends a command for which no caller waits. When it is done or the program has ended, sends "no
    /// command".
    bool sendAlone(int recipe, const std::vector<double>& values);
    /// Returns true if a command without a waiting caller is active. Another command replaces it.
    bool isCommandAlone() const { return alone_ != 0; }
    void forgetCommandAlone() { alone_ = 0; }
    /// Starts sending a heartbeat at least every 20 ms while the connection exists.
    /// Returns  false if another client uses the register
    bool beginHeartbeat();
    void endHeartbeat() { beats_ = false; }
    int heartbeatRegister() const;
    int resultRegister() const { return options_.offset + 1; }
    /// Sends the command register unchanged, as a watchdog signal.
    bool kick();

private:
    RegisterLink(const RegisterLinkOptions& options, std::unique_ptr<rtde::Connection> connection);
    Result<void> findFields();
    void run();
    void publish(const std::vector<double>& values);
    void sendHeartbeat();
    bool sendLocked(int recipe, const std::vector<double>& values);

    RegisterLinkOptions options_;
    std::unique_ptr<rtde::Connection> connection_;
    SoftwareVersion version_;
    std::array<std::size_t, 3> status_{};
    std::array<std::size_t, 3> ints_{};
    std::array<std::size_t, 6> doubles_{};

    std::atomic<bool> alive_{true};
    std::atomic<bool> quit_{false};
    std::atomic<bool> beats_{false};
    std::int32_t beat_ = 0;      ///< protected by `sending_`
    std::atomic<int> alone_{0};  ///< command without a waiting caller; 0: none
    std::mutex sending_;
    std::atomic<int> command_{0};  ///< value of the command register

    mutable std::mutex mutex_;  ///< protects the state
    std::condition_variable changed_;
    RegisterState state_;
    std::thread thread_;
};

}  // namespace tiller::urrtde
