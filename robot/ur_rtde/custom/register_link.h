// SPDX-License-Identifier: MIT
#pragma once

// The RTDE connection to a program of the user's that obeys ur_rtde's registers: what the robot says about
// it, and the recipes commands travel in. Private to this room.

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
    double frequency = 0;  ///< 0: the controller's own
    int offset = 0;        ///< of the registers: 0 or 24
    int priority = 0;
};

/// One package of the robot.
struct RegisterState {
    std::uint64_t sequence = 0;  ///< 0: none yet
    std::uint64_t played = 0;    ///< packages until now in which a program played
    std::uint32_t robotStatus = 0;
    std::uint32_t safetyStatus = 0;
    RuntimeState runtime = RuntimeState::Stopped;
    int answer = 0;    ///< of the program: 0 busy, 1 ready, 2 done
    int answered = 0;  ///< the command that is done; 0: the program does not tell
    int result = 0;    ///< one number
    int progress = 0;  ///< see AsyncOperationStatus
    std::array<double, 6> values{};

    bool isDone(int command) const { return answer == 2 && (answered == 0 || answered == command); }
    bool isPlaying() const { return runtime == RuntimeState::Playing; }
    bool hasEnded() const { return runtime == RuntimeState::Stopped || runtime == RuntimeState::Stopping; }
    /// A protective or an emergency stop.
    bool isStopped() const { return (safetyStatus & ((1U << 2) | (1U << 7))) != 0; }
};

/// Thread: one, named "ur_rtde-control", priority as in the options; started by open(), ended by close() and
/// the destructor within 50 ms. It reads the packages and tells those who wait.
class RegisterLink {
public:
    /// Errors   as rtde::Connection::open; FieldUnknown when the robot has not these registers
    static Result<std::unique_ptr<RegisterLink>> open(const RegisterLinkOptions& options,
                                                      const Deadline& deadline);
    ~RegisterLink();
    RegisterLink(const RegisterLink&) = delete;
    RegisterLink& operator=(const RegisterLink&) = delete;

    // All of the following: threads any.

    void close();
    bool isAlive() const { return alive_; }
    SoftwareVersion version() const { return version_; }
    RegisterState state() const;
    /// Waits for a package that makes `done` true; `giveUp` ends the wait too. Packages that arrive together
    /// may be seen as one: what does not last has to be counted in the state.
    /// Returns  whether `done` was true of the last package seen
    bool wait(const std::function<bool(const RegisterState&)>& done,
              const std::function<bool(const RegisterState&)>& giveUp, std::chrono::milliseconds atMost);
    /// Wakes those who wait, so that they ask again.
    void wake() { changed_.notify_all(); }

    /// recipe  1 ... 20; values in its order, the command first
    /// Returns  false when the robot cannot take it
    bool send(int recipe, const std::vector<double>& values);
    /// Sends "no command".
    bool clear();
    /// As clear(), unless another command has taken this one's place.
    bool clear(CommandId command);
    /// Whether it is the last that was sent.
    bool holds(CommandId command) const { return command_ == static_cast<int>(command); }
    /// Sends a command nobody waits for, and "no command" once it is done or the program has ended.
    bool sendAlone(int recipe, const std::vector<double>& values);
    /// Whether such a command is under way. Another one takes its place.
    bool isCommandAlone() const { return alone_ != 0; }
    void forgetCommandAlone() { alone_ = 0; }
    /// From now on a heartbeat goes to the robot at least every 20 ms, as long as the link is alive.
    /// Returns  false when another client owns the register
    bool beginHeartbeat();
    void endHeartbeat() { beats_ = false; }
    int heartbeatRegister() const;
    int resultRegister() const { return options_.offset + 1; }
    /// Sends the command register as it is, for a watchdog: what is under way goes on.
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
    std::int32_t beat_ = 0;      ///< under `sending_`
    std::atomic<int> alone_{0};  ///< the command nobody waits for; 0: none
    std::mutex sending_;
    std::atomic<int> command_{0};  ///< in the command register

    mutable std::mutex mutex_;  ///< of the state
    std::condition_variable changed_;
    RegisterState state_;
    std::thread thread_;
};

}  // namespace tiller::urrtde
