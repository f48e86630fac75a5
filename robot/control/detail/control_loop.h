// SPDX-License-Identifier: MIT
#pragma once

// What the control thread does between a package from the robot and the package back, without socket and
// thread: a function of the data, the mailbox and the time. Everything that ends a motion without being asked
// is decided here.

#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "robot/control/control_status.h"
#include "robot/control/detail/mailbox.h"
#include "robot/control/detail/registers.h"
#include "robot/control/detail/velocity_limiter.h"
#include "robot/control/stop_meter.h"
#include "robot/realtime/arrival_pace.h"
#include "robot/realtime/seqlock.h"
#include "robot/realtime/stream_watch.h"
#include "robot/realtime/triple_buffer.h"

namespace tiller::control {

/// Data older than this are no ground to move on.
inline constexpr std::int64_t kMaxDataAgeNs = 100'000'000;
/// A link on which a command takes longer than this to the robot and back is none to move on either.
inline constexpr double kMaxRoundTripMs = 100.0;

inline constexpr std::int64_t kNoCycleDue = std::numeric_limits<std::int64_t>::max();

/// What a cycle is run for.
struct Occasion {
    double period = 0.002;  ///< [s]
    bool fresh = true;      ///< the data have just come; otherwise they are those of the package before
    /// Fresh: when it is to begin, to be even, by the clock of Feedback::hostNs.
    std::int64_t evenNs = 0;
    /// Of the data at Feedback::hostNs, by the robot's time stamps, from the fastest arrival seen [ns].
    std::int64_t ageNs = 0;
};

/// Computes the target of one motion in step with the packages: see packet_loop.h.
class CycleHook {
public:
    virtual MotionId motion() const = 0;
    /// Called in the control thread.
    /// Returns  false to end the motion
    virtual bool cycle(const Feedback& data, const Occasion& occasion, MotionCommand& target) = 0;
    /// When the last cycle ended, by the clock of Feedback::hostNs: its target leaves then.
    virtual std::int64_t endedNs() const = 0;
    /// When the next cycle is to run even if no package comes until then; kNoCycleDue: it waits for one.
    virtual std::int64_t dueNs(const realtime::ArrivalPace& pace) const = 0;

protected:
    ~CycleHook() = default;
};

/// Threads  tick(), dueNs(), fallback(), lost(): the control thread. begin(): before it starts. All others:
///          any; ask() and setHook() one at a time.
/// Real-time: yes
class ControlLoop {
public:
    ControlLoop(Mailbox& mailbox, const MotionLimits& limits)
        : mailbox_(mailbox), limits_(limits), speedCap_(limits.tcpSpeed) {}

    /// Prepares for a new connection: nothing is in control until the program with this session answers.
    void begin(std::int32_t session, double period, const ArmLimits& arm, std::int64_t nowNs);
    void setGranted(bool priority, bool cpus, bool fastWakeUps) {
        status_.priorityGranted = priority;
        status_.fastWakeUps = fastWakeUps;
        status_.cpusGranted = cpus;
    }

    /// One package from the robot in, one back.
    Command tick(const Feedback& data);
    /// A package that is not answered, because a newer one has come already.
    void pass(const Feedback& data);
    /// True while the newest package counts alone: a packet loop that took long is not to work off a queue.
    bool wantsNewest();
    /// What tick() returned has been sent.
    void answered() { answeredTime_.store(data_.timestamp, std::memory_order_release); }
    /// When fallback() has something to do although no package came; kNoCycleDue: nothing.
    std::int64_t dueNs();
    /// For when no package comes: ends the motion once the data are too old, and runs the cycle that is due.
    /// Returns  true when `out` shall be sent without waiting any longer
    bool fallback(std::int64_t nowNs, Command& out);
    /// For when somebody has just changed what is to be done and no package is due: sends it at once, but
    /// set points only once between two packages. Returns  true when `out` shall be sent
    bool early(std::int64_t nowNs, Command& out);
    /// The connection is gone.
    void lost(std::int64_t nowNs, ControlLoss loss);

    /// From the next tick on the program is told to end; that it ended is called `loss`.
    void requestEnd(ControlLoss loss = ControlLoss::Released) {
        endLoss_.store(loss, std::memory_order_relaxed);
        endRequested_.store(true, std::memory_order_release);
    }
    /// How old data may be, and how long the program may leave a package unanswered, before a motion ends that
    /// was not given a longer silence.
    /// Threads: before the control thread starts
    void setDataTimeout(std::int64_t ns) { dataTimeoutNs_ = ns; }
    /// The same for the active motion. Threads: the control thread
    std::int64_t dataTimeoutNs() const;
    /// For who joins a program that runs: goes on counting where the client before has ended.
    /// Threads: after begin(), before the control thread starts
    void follow(const Echo& echo);
    /// From the next tick on a move or path may come to its end without us.
    void permitFinish();
    /// Whether the robot has heard of it.
    bool isFinishPermitted() const { return finishHeard_.load(std::memory_order_acquire); }
    /// From the next tick on only the program with this session is ours, and its echo is waited for.
    void expectSession(std::int32_t session) { nextSession_.store(session, std::memory_order_release); }

    /// Puts a request into the packages until another one is asked.
    /// Returns  its number
    std::int32_t ask(Request request);
    /// Takes the request out of the packages: nobody waits for it any more.
    void withdraw();
    /// The newest answer of our program.
    Answer answer() const { return answer_.load(); }
    /// Force mode may go on, until this is taken back: by the caller, an unsafe mode, the loss of control, or
    /// the end of a motion whose holder fell silent.
    void permitForce(bool permitted);
    /// From the next tick on TCP and elbow of a jog get no faster than this [m/s].
    void setSpeedCap(double cap) { speedCap_.store(cap); }
    double speedCap() const { return speedCap_.load(); }
    /// From the next tick on jogs keep the safety distance of this check; null: there is none.
    /// Threads  any; one at a time
    void setCollisionCheck(std::shared_ptr<const collision::CollisionCheck> check) {
        check_.publish(std::move(check));
    }
    /// Null takes it away; when the call returns it is not in use any more.
    void setHook(CycleHook* hook);

    /// For who has just begun a motion: true means that the loss of control, should it come, will end it;
    /// false that the caller must. A look with isInControl() could miss a loss that in turn missed the
    /// motion.
    bool confirmControl();
    bool isInControl() const { return inControl_.load(std::memory_order_acquire); }
    ControllerStatus status() const;
    /// True once after our program was paused: it is of no more use, and what it has begun, force mode for
    /// one, might go on all the same. Threads  the control thread
    bool takePaused() { return std::exchange(paused_, false); }
    /// Whether the arm yielded to forces or hands when it was paused: what ends that is a line of the program,
    /// which does not run then. Threads  the control thread
    bool yieldedWhenPaused() const { return yieldedWhenPaused_; }
    /// Of the newest package.
    ScriptState scriptState() const { return scriptState_.load(std::memory_order_acquire); }
    /// How many packages said that a program plays.
    std::uint64_t playing() const { return playing_.load(std::memory_order_acquire); }
    /// For the time in which no control thread runs.
    void publishLoss(ControlLoss loss);

private:
    void takeIn(const Feedback& data);
    void followEcho(const Feedback& data);
    void watch(const Feedback& data);
    void leave(ControlLoss loss, StopCause cause, std::int64_t nowNs);
    void endActive(StopCause cause, std::int64_t nowNs);
    void compose(const Feedback& data, Command& command);
    void composeProgram(const MotionCommand& motion, const Feedback& data, const Occasion& occasion,
                        Command& command);
    bool cycleWithoutPackage(std::int64_t nowNs, Command& out);
    /// Something is over that the robot was last told to go on with, force mode included.
    bool owesStop() const;
    void composeJog(const MotionCommand& motion, const Feedback& data, Command& command);
    bool feelsContact(const JogTarget& target, const Feedback& data);
    void noteEnded(std::int64_t nowNs);
    void publish();
    void seal(Command& command, std::int64_t nowNs);

    Mailbox& mailbox_;
    MotionLimits limits_;
    std::atomic<double> speedCap_;  ///< in place of limits_.tcpSpeed
    VelocityLimiter limiter_{ArmLimits{}, MotionLimits{}};
    /// The control thread only looks at the newest; who publishes frees the older ones.
    realtime::TripleBuffer<std::shared_ptr<const collision::CollisionCheck>> check_;
    StopMeter meter_;

    std::int32_t session_ = 0;
    double period_ = 0.002;
    std::atomic<bool> inControl_{false};
    std::atomic<bool> endRequested_{false};
    std::atomic<ControlLoss> endLoss_{ControlLoss::Released};
    std::atomic<std::int32_t> nextSession_{0};  ///< 0: none
    std::atomic<bool> forcePermitted_{false};
    std::atomic<bool> mayFinish_{false};
    std::atomic<bool> finishHeard_{false};
    std::int32_t finishSequence_ = 0;  ///< of the first package that permits it; 0: none
    std::int64_t dataTimeoutNs_ = kMaxDataAgeNs;
    bool sentEarly_ = false;  ///< set points, since the newest package
    std::atomic<std::uint64_t> playing_{0};
    std::atomic<ScriptState> scriptState_{ScriptState::Ready};
    std::atomic<CycleHook*> hook_{nullptr};
    std::atomic<bool> hookInUse_{false};
    bool paused_ = false;
    bool yieldedWhenPaused_ = false;
    std::optional<std::int64_t> yieldedNs_;  ///< when force mode, freedrive or teach mode were last asked for
    std::int32_t asked_ = 0;                 ///< under the caller's lock: number of the last request
    realtime::TripleBuffer<Request> request_;
    realtime::Seqlock<Answer> answer_;

    Feedback data_;  ///< the newest
    bool hasData_ = false;
    realtime::ArrivalPace pace_{period_};
    realtime::StreamWatch stream_;
    std::int64_t ageNs_ = 0;       ///< of the newest data when they were read: see Occasion
    std::int64_t arrivedNs_ = 0;   ///< when they came, as far as that is known
    std::int64_t evenNs_ = 0;      ///< when the newest package's cycle is to begin, to be even
    std::int64_t composedNs_ = 0;  ///< when the command was made that is about to be sent
    std::int32_t sequence_ = kBeforeFirstSequence;
    static constexpr std::size_t kSentMemory = 512;
    std::array<std::int64_t, kSentMemory> sentNs_{};
    std::int32_t echoed_ = 0;
    std::int64_t unansweredSinceNs_ =
        0;  ///< when the first package after the last new echo was sent; 0: none

    MotionId sentMotion_ = kNoMotion;                          ///< what the robot was last told to do
    bool sentForce_ = false;                                   ///< whether force mode may go on, by the same
    MotionId followed_ = kNoMotion;                            ///< the motion the last command was for
    bool followedByHand_ = false;                              ///< a jog or a move of the interface
    std::int64_t followedSilenceNs_ = 0;                       ///< what it was given, see MotionCommand
    Pose followedTcp_;                                         ///< TCP offset when it began
    Eigen::Vector3d followedForce_ = Eigen::Vector3d::Zero();  ///< on the TCP when it began
    int pressed_ = 0;  ///< packages in a row in which the TCP was pressed harder than the jog allows

    ControllerStatus status_;
    realtime::Seqlock<ControllerStatus> published_;
    std::atomic<double> answeredTime_{0};  ///< ControllerStatus::answeredTime
};

}  // namespace tiller::control
