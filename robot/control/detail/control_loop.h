// SPDX-License-Identifier: MIT
#pragma once

// Processes a packet from the robot and computes the answer, without sockets or threads. The answer depends
// only on the data, the mailbox and the time. Every automatic stop of a motion is decided here.

#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "robot/control/control_status.h"
#include "robot/control/detail/mailbox.h"
#include "robot/control/detail/motion_delay.h"
#include "robot/control/detail/registers.h"
#include "robot/control/detail/velocity_limiter.h"
#include "robot/control/stop_meter.h"
#include "robot/realtime/arrival_pace.h"
#include "robot/realtime/seqlock.h"
#include "robot/realtime/stream_watch.h"
#include "robot/realtime/triple_buffer.h"
#include "robot/receive/data_age.h"

namespace tiller::control {

/// Maximum age of the data for motion.
inline constexpr std::int64_t kMaxDataAgeNs = std::chrono::nanoseconds(receive::kMaxDataAge).count();
/// Maximum round trip from a command to its echo for motion.
inline constexpr double kMaxRoundTripMs = 100.0;

inline constexpr std::int64_t kNoCycleDue = std::numeric_limits<std::int64_t>::max();

/// Trigger of a cycle.
struct Occasion {
    double period = 0.002;  ///< [s]
    bool fresh = true;      ///< the data are new; false: from the previous packet
    /// If fresh: evenly spaced start time of the cycle, on the clock of Feedback::hostNs.
    std::int64_t evenNs = 0;
    /// Age of the data at Feedback::hostNs [ns], from the robot's timestamps and the fastest observed
    /// arrival.
    std::int64_t ageNs = 0;
};

/// Computes the target of a motion once per packet: see packet_loop.h.
class CycleHook {
public:
    virtual MotionId motion() const = 0;
    /// Called in the control thread.
    /// Returns  false to end the motion
    virtual bool cycle(const Feedback& data, const Occasion& occasion, MotionCommand& target) = 0;
    /// End of the last cycle on the clock of Feedback::hostNs; its target is sent at this time.
    virtual std::int64_t endedNs() const = 0;
    /// Time of the next cycle if no packet arrives. kNoCycleDue: the next cycle waits for a packet.
    virtual std::int64_t dueNs(const realtime::ArrivalPace& pace) const = 0;

protected:
    ~CycleHook() = default;
};

/// Threads  tick(), dueNs(), fallback(), lost(): the control thread. begin(): before the control thread
///          starts. All others: any, with ask() and setHook() one at a time.
/// Real-time: yes
class ControlLoop {
public:
    ControlLoop(Mailbox& mailbox, const MotionLimits& limits)
        : mailbox_(mailbox), limits_(limits), speedCap_(limits.tcpSpeed) {}

    /// Resets the state for a new connection. Control begins when the program with this session responds.
    void begin(std::int32_t session, double period, const ArmLimits& arm, std::int64_t nowNs);
    void setGranted(bool priority, bool cpus, bool fastWakeUps) {
        status_.priorityGranted = priority;
        status_.fastWakeUps = fastWakeUps;
        status_.cpusGranted = cpus;
    }

    /// Processes one packet from the robot and returns the answer.
    Command tick(const Feedback& data);
    /// Processes a packet that needs no answer because a newer packet has arrived.
    void pass(const Feedback& data);
    /// True if only the newest packet is needed, because a slow packet loop must not process a backlog.
    bool wantsNewest();
    /// Call after sending the result of tick().
    void answered() { answeredTime_.store(data_.timestamp, std::memory_order_release); }
    /// Time at which fallback() must be called if no packet arrives. kNoCycleDue: never.
    std::int64_t dueNs();
    /// Call if no packet arrives. Ends the motion when the data are too old, and runs a scheduled cycle.
    /// Returns  true if `out` must be sent at once
    bool fallback(std::int64_t nowNs, Command& out);
    /// Call after a change by another thread while no packet is due. Commands are sent at once, but only one
    /// setpoint between two packets.
    /// Returns  true if `out` must be sent
    bool early(std::int64_t nowNs, Command& out);
    /// Call after loss of the connection.
    void lost(std::int64_t nowNs, ControlLoss loss);

    /// Requests the end of the program starting with the next tick. `loss` is reported when the program has
    /// ended.
    void requestEnd(ControlLoss loss = ControlLoss::Released) {
        endLoss_.store(loss, std::memory_order_relaxed);
        endRequested_.store(true, std::memory_order_release);
    }
    /// Maximum age of the data and maximum response time of the program. A motion without a longer timeout
    /// ends when either is exceeded.
    /// Threads: before the control thread starts
    void setDataTimeout(std::int64_t ns) { dataTimeoutNs_ = ns; }
    /// Returns this limit for the active motion. Threads: the control thread
    std::int64_t dataTimeoutNs() const;
    /// For joining a running program: continues with the sequence and epoch of the previous client.
    /// Threads: after begin(), before the control thread starts
    void follow(const Echo& echo);
    /// Permits a move or path to complete without a client, starting with the next tick.
    void permitFinish();
    /// True if the robot has received this permission.
    bool isFinishPermitted() const { return finishReceived_.load(std::memory_order_acquire); }
    /// Accepts only the program with this session, starting with the next tick. Withdraws earlier requests to
    /// end a program.
    void expectSession(std::int32_t session) {
        endRequested_.store(false, std::memory_order_release);
        takingAbandoned_.store(false, std::memory_order_release);
        nextSession_.store(session, std::memory_order_release);
    }
    /// Call if the control program could not be sent, or not sent again after a script: starting with the
    /// next tick, the loss is ScriptStopped.
    void abandonTaking() { takingAbandoned_.store(true, std::memory_order_release); }

    /// Adds a request to each package until the next request replaces it.
    /// Returns  the number of the request
    std::int32_t ask(Request request);
    /// Removes the request from the packages when its caller has stopped waiting.
    void withdraw();
    /// Newest answer of the program.
    Answer answer() const { return answer_.load(); }
    /// Permits a motion of Kind::Script after the control program has ended. Call with true before starting
    /// the motion and with false after its end.
    void permitScript(bool permitted);
    /// Permits force mode. The caller, an unsafe mode, the loss of control, or the end of a motion that was
    /// not refreshed in time revokes the permission.
    void permitForce(bool permitted);
    /// Speed limit of TCP and elbow for jogs [m/s], starting with the next tick.
    void setSpeedCap(double cap) { speedCap_.store(cap); }
    double speedCap() const { return speedCap_.load(); }
    /// Makes jogs keep the safety distance of this check starting with the next tick; null: no check.
    /// Threads  any; one at a time
    void setCollisionCheck(std::shared_ptr<const collision::CollisionCheck> check) {
        check_.publish(std::move(check));
    }
    /// Sets the hook; null removes it. After this call has returned, the previous hook is not used.
    void setHook(CycleHook* hook);

    /// Call after starting a motion. True guarantees that a later loss of control ends the motion. False
    /// means that the caller must end the motion. isInControl() does not give this guarantee, because control
    /// may be lost at the same time.
    bool confirmControl();
    bool isInControl() const { return inControl_.load(std::memory_order_acquire); }
    ControllerStatus status() const;
    /// The last delay that ended a motion. Available as soon as the motion has ended.
    MotionDelay delay() const { return delay_.load(); }
    /// Returns true once after the program was paused. A paused program must not be used again, because its
    /// effects, such as force mode, might continue.
    /// Threads  the control thread
    bool takePaused() { return std::exchange(paused_, false); }
    /// True if force mode, freedrive or teach mode was active at the pause. Only the paused program could end
    /// these modes.
    /// Threads  the control thread
    bool yieldedWhenPaused() const { return yieldedWhenPaused_; }
    /// State of the control program according to the newest packet.
    ScriptState scriptState() const { return scriptState_.load(std::memory_order_acquire); }
    /// Publishes a loss of control while no control thread exists.
    void publishLoss(ControlLoss loss);

private:
    void takeIn(const Feedback& data);
    void followEcho(const Feedback& data);
    void watch(const Feedback& data);
    void leave(ControlLoss loss, StopCause cause, std::int64_t nowNs);
    void endActive(StopCause cause, std::int64_t nowNs);
    void endDelayed(StopCause cause, MotionDelay::Kind kind, std::int64_t measuredNs, std::int64_t nowNs);
    void noteLook(std::int64_t nowNs);
    std::int64_t longestSendGapNs() const;
    void compose(const Feedback& data, Command& command);
    void composeProgram(const MotionCommand& motion, const Feedback& data, const Occasion& occasion,
                        Command& command);
    void watchScript(const Feedback& data);
    bool cycleWithoutPackage(std::int64_t nowNs, Command& out);
    /// True if a motion or force mode has ended on this side but may still be active on the robot.
    bool isStopPending() const;
    void composeJog(const MotionCommand& motion, const Feedback& data, Command& command);
    bool feelsContact(const JogTarget& target, const Feedback& data);
    void noteEnded(std::int64_t nowNs);
    void measureStop(const Feedback& data);
    void publish();
    void seal(Command& command, std::int64_t nowNs);

    Mailbox& mailbox_;
    MotionLimits limits_;
    std::atomic<double> speedCap_;  ///< replaces limits_.tcpSpeed
    VelocityLimiter limiter_{ArmLimits{}, MotionLimits{}};
    /// The control thread only reads the newest value. The publisher frees older ones.
    realtime::TripleBuffer<std::shared_ptr<const collision::CollisionCheck>> check_;
    StopMeter meter_;

    std::int32_t session_ = 0;
    double period_ = 0.002;
    std::atomic<bool> inControl_{false};
    std::atomic<bool> endRequested_{false};
    std::atomic<ControlLoss> endLoss_{ControlLoss::Released};
    std::atomic<std::int32_t> nextSession_{0};  ///< 0: none
    std::atomic<bool> takingAbandoned_{false};
    std::atomic<bool> forcePermitted_{false};
    std::atomic<bool> scriptPermitted_{false};
    std::atomic<bool> mayFinish_{false};
    std::atomic<bool> finishReceived_{false};
    std::int32_t finishSequence_ = 0;  ///< sequence number of the first package with the permission; 0: none
    std::int64_t dataTimeoutNs_ = kMaxDataAgeNs;
    bool sentEarly_ = false;  ///< a setpoint was sent since the newest packet
    std::atomic<ScriptState> scriptState_{ScriptState::Ready};
    std::atomic<CycleHook*> hook_{nullptr};
    std::atomic<bool> hookInUse_{false};
    bool paused_ = false;
    bool yieldedWhenPaused_ = false;
    std::optional<std::int64_t> yieldedNs_;  ///< time of the last force, freedrive or teach mode command
    std::int32_t asked_ = 0;                 ///< number of the last request; protected by the caller's lock
    realtime::TripleBuffer<Request> request_;
    realtime::Seqlock<Answer> answer_;

    Feedback data_;
    bool hasData_ = false;
    realtime::ArrivalPace pace_{period_};
    realtime::StreamWatch stream_;
    std::int64_t ageNs_ = 0;       ///< age of the newest data when read: see Occasion
    std::int64_t arrivedNs_ = 0;   ///< estimated arrival time
    std::int64_t evenNs_ = 0;      ///< start of the newest packet's cycle for even spacing
    std::int64_t composedNs_ = 0;  ///< creation time of the command to be sent
    std::int64_t lookedNs_ = 0;    ///< last time the control thread ran
    std::int64_t stalledNs_ = 0;   ///< MotionDelay::stalledNs since the newest packet
    std::int32_t sequence_ = kBeforeFirstSequence;
    static constexpr std::size_t kSentMemory = 512;
    std::array<std::int64_t, kSentMemory> sentNs_{};
    std::int32_t echoed_ = 0;
    std::int64_t unansweredSinceNs_ = 0;  ///< send time of the first package since the last new echo; 0: none

    MotionId sentMotion_ = kNoMotion;     ///< last motion sent to the robot
    bool sentForce_ = false;              ///< force mode permission sent with the last motion
    MotionId followed_ = kNoMotion;       ///< motion of the last command
    bool followedHoldToRun_ = false;      ///< true for a jog or a move started by the operator
    bool followsScript_ = false;          ///< `followed_` is a motion of Kind::Script
    std::int64_t followedTimeoutNs_ = 0;  ///< heartbeat timeout of the last motion
    Pose followedTcp_;                    ///< TCP offset at the start of the jog
    Eigen::Vector3d followedForce_ = Eigen::Vector3d::Zero();  ///< force at the TCP at the start of the jog
    int pressed_ = 0;  ///< number of consecutive packets with a force above the jog's limit

    ControllerStatus status_;
    realtime::Seqlock<ControllerStatus> published_;
    realtime::Seqlock<MotionDelay> delay_;
    std::atomic<double> answeredTime_{0};  ///< ControllerStatus::answeredTime
};

}  // namespace tiller::control
