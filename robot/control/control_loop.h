// SPDX-License-Identifier: MIT
#pragma once

// What the control thread does between a package from the robot and the package back, without socket and
// thread: a function of the data, the mailbox and the time. Everything that ends a motion without being asked
// is decided here.

#include <array>
#include <atomic>
#include <cstdint>

#include "robot/control/control_status.h"
#include "robot/control/mailbox.h"
#include "robot/control/registers.h"
#include "robot/control/stop_meter.h"
#include "robot/control/velocity_limiter.h"
#include "robot/realtime/seqlock.h"

namespace tiller::control {

/// Data older than this are no ground to move on.
inline constexpr std::int64_t kMaxDataAgeNs = 100'000'000;
/// A link on which a command takes longer than this to the robot and back is none to move on either.
inline constexpr double kMaxRoundTripMs = 100.0;

/// Threads  tick(), fallback(), lost(): the control thread. requestEnd(), status(), isInControl(): any.
///          begin(): before the control thread starts.
/// Real-time: yes
class ControlLoop {
public:
    ControlLoop(Mailbox& mailbox, const MotionLimits& limits) : mailbox_(mailbox), limits_(limits) {}

    /// Prepares for a new connection: nothing is in control until the program with this session answers.
    void begin(std::int32_t session, double period, const ArmLimits& arm, std::int64_t nowNs);
    void setPriorityGranted(bool granted) { status_.priorityGranted = granted; }

    /// One package from the robot in, one back.
    Command tick(const Feedback& data);
    /// For when no package comes: ends the motion once the data are too old.
    /// Returns  true when `out` shall be sent without waiting any longer
    bool fallback(std::int64_t nowNs, Command& out);
    /// The connection is gone.
    void lost(std::int64_t nowNs, ControlLoss loss);

    /// From the next tick on the program is told to end.
    void requestEnd() { endRequested_.store(true, std::memory_order_release); }

    bool isInControl() const { return inControl_.load(std::memory_order_acquire); }
    ControllerStatus status() const { return published_.load(); }
    /// For the time in which no control thread runs.
    void publishLoss(ControlLoss loss);

private:
    void followEcho(const Feedback& data);
    void watch(const Feedback& data);
    void leave(ControlLoss loss, StopCause cause, std::int64_t nowNs);
    void endActive(StopCause cause, std::int64_t nowNs);
    void compose(const Feedback& data, Command& command);
    void composeJog(const MotionCommand& motion, const Feedback& data, Command& command);
    void noteEnded(std::int64_t nowNs);
    void publish();
    void seal(Command& command, std::int64_t nowNs);

    Mailbox& mailbox_;
    MotionLimits limits_;
    VelocityLimiter limiter_{ArmLimits{}, MotionLimits{}};
    StopMeter meter_;

    std::int32_t session_ = 0;
    double period_ = 0.002;
    std::atomic<bool> inControl_{false};
    std::atomic<bool> endRequested_{false};

    Feedback data_;  ///< the newest
    bool hasData_ = false;
    std::int32_t sequence_ = 0;
    static constexpr std::size_t kSentMemory = 512;
    std::array<std::int64_t, kSentMemory> sentNs_{};
    std::int32_t echoed_ = 0;
    std::int64_t unansweredSinceNs_ =
        0;  ///< when the first package after the last new echo was sent; 0: none

    MotionId sentMotion_ = kNoMotion;  ///< what the robot was last told to do
    MotionId followed_ = kNoMotion;    ///< the motion the last command was for
    Pose followedTcp_;                 ///< TCP offset when it began

    ControllerStatus status_;
    realtime::Seqlock<ControllerStatus> published_;
};

}  // namespace tiller::control
