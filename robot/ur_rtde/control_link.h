// SPDX-License-Identifier: MIT
#pragma once

// The RTDE connection of RTDEControlInterface: what the robot says about the control program, and the recipes
// commands travel in. The registers and recipes are those that control programs written for ur_rtde use, so
// that customised ones work too; the heartbeat is ours. Private to this room.

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

namespace tiller::urrtde {

struct LinkOptions {
    QString host;
    double frequency = 0;  ///< 0: the controller's own
    int offset = 0;        ///< of the registers: 0 or 24
    int priority = 0;
};

/// The numbers the control program knows.
enum class CommandId : int {
    MoveJ = 1,
    MoveJIk = 2,
    MoveL = 3,
    MoveLFk = 4,
    ForceMode = 6,
    ForceModeStop = 7,
    ZeroFtSensor = 8,
    SpeedJ = 9,
    SpeedL = 10,
    ServoJ = 11,
    ServoC = 12,
    SpeedStop = 15,
    ServoStop = 16,
    SetPayload = 17,
    TeachMode = 18,
    EndTeachMode = 19,
    ForceModeDamping = 20,
    ForceModeGainScaling = 21,
    ServoL = 24,
    ToolContact = 25,
    StepTime = 26,
    JointPositionsHistory = 27,
    TargetWaypoint = 28,
    SetTcp = 29,
    InverseKinematicsNear = 30,
    ProtectiveStop = 31,
    StopL = 33,
    StopJ = 34,
    SetWatchdog = 35,
    PoseWithinLimits = 36,
    JointsWithinLimits = 37,
    JointTorques = 38,
    PoseTrans = 39,
    TcpOffset = 40,
    JogStart = 41,
    JogStop = 42,
    ForwardKinematics = 43,
    ForwardKinematicsOf = 44,
    MovePath = 45,
    InverseKinematics = 46,
    IsSteady = 47,
    MoveUntilContact = 51,
    FreedriveMode = 52,
    EndFreedriveMode = 53,
    FreedriveStatus = 54,
    ExternalForceTorque = 55,
    FtRtdeInput = 56,
    ExternalFtSensor = 57,
    ToolFlangePose = 58,
    SetGravity = 59,
    HasSolution = 60,
    HasSolutionNear = 61,
    StartContactDetection = 62,
    StopContactDetection = 63,
    ReadContactDetection = 64,
    StopScript = 255,
};

/// One package of the robot.
struct LinkState {
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
/// the destructor within 50 ms. It reads the packages, answers each with a heartbeat, and tells those who
/// wait.
class ControlLink {
public:
    /// Errors   as rtde::Connection::open; FieldUnknown when the robot has not these registers
    static Result<std::unique_ptr<ControlLink>> open(const LinkOptions& options, const Deadline& deadline);
    ~ControlLink();
    ControlLink(const ControlLink&) = delete;
    ControlLink& operator=(const ControlLink&) = delete;

    // All of the following: threads any.

    void close();
    bool isAlive() const { return alive_; }
    SoftwareVersion version() const { return version_; }
    LinkState state() const;
    /// Waits for a package that makes `done` true; `giveUp` ends the wait too. Packages that arrive together
    /// may be seen as one: what does not last has to be counted in the state.
    /// Returns  whether `done` was true of the last package seen
    bool wait(const std::function<bool(const LinkState&)>& done,
              const std::function<bool(const LinkState&)>& giveUp, std::chrono::milliseconds atMost);
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
    /// Sends the command register as it is, for a watchdog: what is under way goes on.
    bool kick();
    /// Tells the program that what follows is a new command of a stream.
    void countStream() { ++streams_; }

private:
    ControlLink(const LinkOptions& options, std::unique_ptr<rtde::Connection> connection);
    Result<void> findFields();
    void run();
    void publish(const std::vector<double>& values);
    void beat();
    bool sendLocked(int recipe, const std::vector<double>& values);

    LinkOptions options_;
    std::unique_ptr<rtde::Connection> connection_;
    SoftwareVersion version_;
    std::array<std::size_t, 3> status_{};
    std::array<std::size_t, 3> ints_{};
    std::array<std::size_t, 6> doubles_{};

    std::atomic<bool> alive_{true};
    std::atomic<bool> quit_{false};
    std::atomic<int> alone_{0};  ///< the command nobody waits for; 0: none
    std::atomic<int> streams_{0};
    int heartbeat_ = 0;
    std::mutex sending_;
    std::atomic<int> command_{0};  ///< in the command register

    mutable std::mutex mutex_;  ///< of the state
    std::condition_variable changed_;
    LinkState state_;
    std::thread thread_;
};

}  // namespace tiller::urrtde
