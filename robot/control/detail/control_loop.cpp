// SPDX-License-Identifier: MIT
#include "robot/control/detail/control_loop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "robot/core/clock.h"

namespace tiller::control {

namespace {

// After this time without an answer, the program is considered ended.
constexpr std::int64_t kEchoLostNs = 500 * kNsPerMs;

/// Cap [mm/s], at least 1, because 0 means that no torques were sent. kNoCap becomes a value that is never
/// reached.
std::int32_t inMillimetres(double cap) {
    constexpr double kLargest = 1e6;
    constexpr double kMillimetresPerMetre = 1000;
    return static_cast<std::int32_t>(std::clamp(std::round(cap * kMillimetresPerMetre), 1.0, kLargest));
}

/// The integer nearest to the value; 0 if the value is not finite.
std::int32_t wholeOf(double value) {
    using Limits = std::numeric_limits<std::int32_t>;
    return std::isfinite(value) ? static_cast<std::int32_t>(
                                      std::clamp<double>(std::round(value), Limits::min(), Limits::max()))
                                : 0;
}

double fastest(const JointVelocities& qd) {
    return qd.values.cwiseAbs().maxCoeff();
}

}  // namespace

void ControlLoop::begin(std::int32_t session, double period, const ArmLimits& arm, std::int64_t nowNs) {
    session_ = session;
    period_ = period;
    limiter_ = VelocityLimiter(arm, limits_);
    meter_.cancel();
    inControl_.exchange(false, std::memory_order_acq_rel);
    endRequested_.store(false, std::memory_order_release);
    nextSession_.store(0, std::memory_order_release);
    takingAbandoned_.store(false, std::memory_order_release);
    forcePermitted_.exchange(false, std::memory_order_acq_rel);
    mayFinish_ = false;
    finishReceived_ = false;
    finishSequence_ = 0;
    request_.publish({});
    data_ = {};
    data_.hostNs = nowNs;
    hasData_ = false;
    pace_ = realtime::ArrivalPace(period);
    stream_.begin(period);
    unansweredSinceNs_ = 0;
    lookedNs_ = nowNs;
    stalledNs_ = 0;
    paused_ = false;
    yieldedWhenPaused_ = false;
    yieldedNs_.reset();
    followed_ = kNoMotion;
    followsScript_ = false;
    sentMotion_ = kNoMotion;
    sentForce_ = false;
    status_.inControl = false;
    status_.loss = ControlLoss::Taking;
    status_.roundTripMs = 0;
    status_.ticks = 0;
    status_.late = 0;
    status_.limiter = {};
    answeredTime_.store(0, std::memory_order_release);
    publish();
}

void ControlLoop::follow(const Echo& echo) {
    session_ = echo.session;
    sequence_ = echo.sequence;
    asked_ = echo.answer.number;
}

void ControlLoop::permitFinish() {
    mayFinish_.store(true, std::memory_order_release);
}

void ControlLoop::permitScript(bool permitted) {
    if (permitted) {
        endRequested_.store(false, std::memory_order_release);
    }
    scriptPermitted_.store(permitted, std::memory_order_release);
}

void ControlLoop::permitForce(bool permitted) {
    // Write the permission before checking for a stop. A stop writes in the opposite order: first the stop,
    // then the revocation. Exchanges of the same atomic are ordered, so the later exchange sees all writes
    // that precede the earlier exchange. A plain store would break this order.
    forcePermitted_.exchange(permitted, std::memory_order_acq_rel);
}

bool ControlLoop::confirmControl() {
    bool inControl = true;
    return inControl_.compare_exchange_strong(inControl, true, std::memory_order_acq_rel);
}

void ControlLoop::withdraw() {
    request_.publish({});
}

std::int32_t ControlLoop::ask(Request request) {
    constexpr std::int32_t kLast = 0x3fffffff;
    asked_ = asked_ >= kLast ? 1 : asked_ + 1;
    request.number = asked_;
    request_.publish(request);
    return asked_;
}

void ControlLoop::setHook(CycleHook* hook) {
    hook_.store(hook);
    // Sleep instead of yield, so that a thread with lower priority can run.
    while (hookInUse_.load()) {
        std::this_thread::sleep_for(std::chrono::microseconds(50));
    }
}

void ControlLoop::takeIn(const Feedback& data) {
    if (const std::int32_t session = nextSession_.exchange(0, std::memory_order_acq_rel); session != 0) {
        session_ = session;
        leave(ControlLoss::Taking, StopCause::ControlLost, data.hostNs);
    }
    if (takingAbandoned_.exchange(false, std::memory_order_acq_rel) &&
        (status_.loss == ControlLoss::Taking || status_.loss == ControlLoss::OwnScript)) {
        status_.loss = ControlLoss::ScriptStopped;
    }
    noteLook(data.hostNs);
    const std::int64_t sinceLast = data.hostNs - data_.hostNs;
    if (hasData_) {
        if (static_cast<double>(sinceLast) > 1.5 * period_ * static_cast<double>(kNsPerSecond)) {
            ++status_.late;
        }
        // Data arrive again, but earlier commands are too old to be continued.
        if (sinceLast > dataTimeoutNs()) {
            endDelayed(StopCause::DataStale, MotionDelay::Kind::Data, sinceLast, data.hostNs);
        }
    }
    stalledNs_ = 0;
    data_ = data;
    sentEarly_ = false;
    ageNs_ = std::max<std::int64_t>(stream_.add(data.timestamp, data.hostNs).jitterNs, 0);
    // The packet may have waited in the queue since the last check.
    arrivedNs_ = data.awaited ? data.hostNs : std::max(data.hostNs - ageNs_, data.lookedNs);
    if (!hasData_) {
        hasData_ = true;
        echoed_ = data.echo.sequence;
    }
    followEcho(data);
    watch(data);
}

void ControlLoop::pass(const Feedback& data) {
    takeIn(data);
    noteEnded(data.hostNs);
    measureStop(data);
}

Command ControlLoop::tick(const Feedback& data) {
    takeIn(data);
    evenNs_ = pace_.follow(data.hostNs, data.timestamp, data.awaited);
    ++status_.ticks;

    Command command;
    composedNs_ = data.hostNs;
    compose(data, command);
    noteEnded(data.hostNs);
    measureStop(data);
    seal(command, composedNs_);
    publish();
    return command;
}

void ControlLoop::measureStop(const Feedback& data) {
    // After control.script has ended, only a program of another client can be running. Its motion is not part
    // of the stop. control.script may continue after a pause.
    const bool ended = status_.loss == ControlLoss::Released || status_.loss == ControlLoss::EchoStalled ||
                       (status_.loss == ControlLoss::ScriptStopped && !paused_);
    if (ended && !isInControl() && !scriptPermitted_.load(std::memory_order_acquire) &&
        data.runtimeState == RuntimeState::Playing) {
        meter_.abandon(UnmeasuredStop::Reason::OtherProgram);
    }
    meter_.add({data.hostNs, data.tcpPose.position, data.tcpSpeed.linear.norm(), fastest(data.qd)});
}

ControllerStatus ControlLoop::status() const {
    // Read this value first, so that the other values include the answered packet.
    const double answeredTime = answeredTime_.load(std::memory_order_acquire);
    ControllerStatus status = published_.load();
    status.answeredTime = answeredTime;
    return status;
}

bool ControlLoop::fallback(std::int64_t nowNs, Command& out) {
    noteLook(nowNs);
    const std::int64_t age = nowNs - data_.hostNs;
    if (age > dataTimeoutNs()) {
        endDelayed(StopCause::DataStale, MotionDelay::Kind::Data, age, nowNs);
    }
    if (dueNs() <= nowNs && cycleWithoutPackage(nowNs, out)) {
        return true;
    }
    // Ends a motion that was not refreshed, even without a tick.
    mailbox_.active(nowNs);
    noteEnded(nowNs);
    publish();
    // A slightly late packet needs no reaction. The next tick sends the stop.
    constexpr std::int64_t kAnswerTimeoutNs = 10 * kNsPerMs;
    if (age < kAnswerTimeoutNs || !isStopPending()) {
        return false;
    }
    out = {};
    seal(out, nowNs);
    return true;
}

std::int64_t ControlLoop::dueNs() {
    hookInUse_.store(true);
    const CycleHook* const hook = hook_.load();
    const bool waits = hook != nullptr && hook->motion() == followed_ && !endRequested_.load();
    const std::int64_t due = waits ? hook->dueNs(pace_) : kNoCycleDue;
    hookInUse_.store(false);
    return due;
}

bool ControlLoop::wantsNewest() {
    hookInUse_.store(true);
    const CycleHook* const hook = hook_.load();
    const bool hooked = hook != nullptr && hook->motion() == followed_;
    hookInUse_.store(false);
    return hooked;
}

bool ControlLoop::cycleWithoutPackage(std::int64_t nowNs, Command& out) {
    const MotionCommand* motion = mailbox_.active(nowNs);
    if (motion == nullptr || motion->id != followed_) {
        return false;  // the next packet determines the reaction
    }
    out = {};
    composedNs_ = nowNs;
    composeProgram(*motion, data_, {period_, false, nowNs, ageNs_}, out);
    noteEnded(nowNs);
    seal(out, nowNs);
    publish();
    return true;
}

bool ControlLoop::isStopPending() const {
    return sentMotion_ != kNoMotion ? !mailbox_.epoch().isActive(sentMotion_)
                                    : sentForce_ && !forcePermitted_.load(std::memory_order_acquire);
}

bool ControlLoop::early(std::int64_t nowNs, Command& out) {
    const bool commands = isInControl() || followsScript_;
    if (!hasData_ || !commands || endRequested_.load(std::memory_order_acquire)) {
        return false;
    }
    hookInUse_.store(true);
    const bool hooked = hook_.load() != nullptr;
    hookInUse_.store(false);
    const MotionCommand* motion = hooked ? nullptr : mailbox_.active(nowNs);
    if (motion != nullptr && (motion->id != followed_ || motion->kind != MotionCommand::Kind::Program)) {
        return false;  // the start depends on the current arm position
    }
    // Setpoints are limited to one per packet. Stops are not limited.
    if (motion != nullptr ? sentEarly_ : !isStopPending()) {
        return false;
    }
    out = {};
    if (motion != nullptr) {
        sentEarly_ = true;
        composeProgram(*motion, data_, {period_, false, nowNs, ageNs_}, out);
    }
    noteEnded(nowNs);
    seal(out, nowNs);
    publish();
    return true;
}

void ControlLoop::lost(std::int64_t nowNs, ControlLoss loss) {
    if (const std::int64_t age = nowNs - data_.hostNs; age > dataTimeoutNs()) {
        endDelayed(StopCause::LinkLost, MotionDelay::Kind::Data, age, nowNs);
    }
    leave(loss, StopCause::LinkLost, nowNs);
    noteEnded(nowNs);
    meter_.abandon(UnmeasuredStop::Reason::DataGap);
    status_.moving = false;
    publish();
}

void ControlLoop::publishLoss(ControlLoss loss) {
    status_.inControl = false;
    status_.loss = loss;
    status_.moving = false;
    status_.executing = false;
    inControl_.exchange(false, std::memory_order_acq_rel);
    publish();
}

std::int64_t ControlLoop::dataTimeoutNs() const {
    const bool follows = followed_ != kNoMotion && mailbox_.epoch().isActive(followed_);
    return follows ? std::max(dataTimeoutNs_, followedTimeoutNs_) : dataTimeoutNs_;
}

void ControlLoop::followEcho(const Feedback& data) {
    const Echo& echo = data.echo;
    scriptState_.store(echo.state, std::memory_order_release);
    if (echo.session != session_) {
        return;
    }
    answer_.store(echo.answer);
    if (echo.sequence == echoed_) {
        return;
    }
    echoed_ = echo.sequence;
    unansweredSinceNs_ = 0;
    if (finishSequence_ != 0 && echo.sequence >= finishSequence_) {
        finishReceived_.store(true, std::memory_order_release);
    }
    const std::int32_t behind = sequence_ - echo.sequence;
    if (behind >= 0 && static_cast<std::size_t>(behind) >= kSentMemory) {
        // The command is older than all stored send times, so the round trip takes at least the time between
        // the first and the last of these send times.
        status_.roundTripMs = static_cast<double>(kSentMemory) * period_ * 1000.0;
    }
    if (behind >= 0 && static_cast<std::size_t>(behind) < kSentMemory) {
        const auto slot = static_cast<std::size_t>(echo.sequence) % kSentMemory;
        status_.roundTripMs = static_cast<double>(std::max<std::int64_t>(arrivedNs_ - sentNs_[slot], 0)) /
                              static_cast<double>(kNsPerMs);
        // Control begins when the expected program and session respond.
        const bool taking = !isInControl() && status_.loss == ControlLoss::Taking;
        if (taking && data.runtimeState == RuntimeState::Playing) {
            status_.inControl = true;
            status_.loss = ControlLoss::None;
            inControl_.exchange(true, std::memory_order_acq_rel);
        }
    }
}

// Ends the motion if the data no longer permit it.
void ControlLoop::watch(const Feedback& data) {
    status_.robotMode = data.robotMode;
    status_.safetyMode = data.safetyMode;
    status_.speedFraction = data.speedFraction;
    status_.dataTimeNs = data.hostNs;
    status_.q = data.q.array();
    status_.tcpPose = data.tcpPose.array();
    status_.tcpOffset = data.tcpOffset.array();
    status_.speedScaling = data.speedScaling;
    status_.runtimeState = data.runtimeState;
    status_.robotStatusBits = data.robotStatusBits;
    status_.safetyStatusBits = data.safetyStatusBits;
    status_.forceKnown = data.tcpForce.has_value();
    if (data.runtimeState == RuntimeState::Playing) {
        ++status_.playing;
    }
    if (data.robotMode != RobotMode::Running || !allowsMotion(data.safetyMode)) {
        endActive(StopCause::UnsafeMode, data.hostNs);
        forcePermitted_.exchange(false, std::memory_order_acq_rel);
    }
    if (!isInControl()) {
        watchScript(data);
        return;
    }
    if (data.runtimeState != RuntimeState::Playing) {
        const bool asked = endRequested_.load(std::memory_order_acquire);
        paused_ = data.runtimeState == RuntimeState::Pausing || data.runtimeState == RuntimeState::Paused;
        // A safeguard stop ends the motion some packets before it pauses the program.
        constexpr std::int64_t kUntilPausedNs = 500 * kNsPerMs;
        yieldedWhenPaused_ = yieldedNs_ && data.hostNs - *yieldedNs_ < kUntilPausedNs;
        leave(asked ? endLoss_.load(std::memory_order_relaxed) : ControlLoss::ScriptStopped,
              StopCause::ControlLost, data.hostNs);
        return;
    }
    const std::int64_t unanswered = unansweredSinceNs_ == 0 ? 0 : data.hostNs - unansweredSinceNs_;
    if (unanswered > std::max(kEchoLostNs, dataTimeoutNs())) {
        leave(ControlLoss::EchoStalled, StopCause::ControlLost, data.hostNs);
        return;
    }
    if (unanswered > dataTimeoutNs()) {
        endDelayed(StopCause::ControlLost, MotionDelay::Kind::Answer, unanswered, data.hostNs);
    }
    // Data arrive, but too late: a stop would also be late.
    const auto roundTripNs = static_cast<std::int64_t>(status_.roundTripMs * static_cast<double>(kNsPerMs));
    if (roundTripNs > dataTimeoutNs()) {
        endDelayed(StopCause::LinkLost, MotionDelay::Kind::RoundTrip, roundTripNs, data.hostNs);
    }
    const MotionId motion = mailbox_.epoch().activeMotion();
    const bool answersThis = motion != kNoMotion && data.echo.epoch == static_cast<std::int32_t>(motion);
    status_.executing = answersThis && data.echo.state == ScriptState::Executing;
    status_.waypoint = answersThis ? data.echo.waypoint : status_.waypoint;
    if (data.echo.state != ScriptState::Executing && data.echo.state != ScriptState::Braking) {
        status_.restingEpoch = std::max(status_.restingEpoch, static_cast<std::uint64_t>(data.echo.epoch));
    }
    if (answersThis) {
        switch (data.echo.state) {
            case ScriptState::Done:
                endActive(StopCause::Completed, data.hostNs);
                break;
            case ScriptState::Expired:
                endDelayed(StopCause::LinkLost, MotionDelay::Kind::Heartbeat, longestSendGapNs(),
                           data.hostNs);
                break;
            case ScriptState::OutOfReach:
                endActive(StopCause::Unreachable, data.hostNs);
                break;
            case ScriptState::Contact:
                endActive(StopCause::Contact, data.hostNs);
                break;
            case ScriptState::TooFar:
                endActive(StopCause::TargetTooFar, data.hostNs);
                break;
            case ScriptState::TcpTooFast:
            case ScriptState::ElbowTooFast:
                status_.limiter = {};
                status_.limiter.kind = data.echo.state == ScriptState::TcpTooFast ? LimiterKind::TcpSpeed
                                                                                  : LimiterKind::ElbowSpeed;
                status_.limiter.scale = 0;
                endActive(StopCause::LimitReached, data.hostNs);
                break;
            case ScriptState::Ready:
            case ScriptState::Executing:
            case ScriptState::Braking:
            case ScriptState::HeartbeatExpired:
                break;
        }
    }
    // A change of the TCP offset during a jog would shift the centre of rotation.
    constexpr double kSameOffset = 1e-6;
    const bool tcpChanged = (data.tcpOffset.position - followedTcp_.position).norm() > kSameOffset ||
                            (data.tcpOffset.rotation - followedTcp_.rotation).norm() > kSameOffset;
    if (motion != kNoMotion && motion == followed_ && followedHoldToRun_ && tcpChanged) {
        endActive(StopCause::SelectionChanged, data.hostNs);
    }
}

// Without control, only the program of a user can move the arm.
void ControlLoop::watchScript(const Feedback& data) {
    const bool permitted = scriptPermitted_.load(std::memory_order_acquire);
    const MotionCommand* script = mailbox_.active(data.hostNs);
    const bool paused =
        data.runtimeState == RuntimeState::Pausing || data.runtimeState == RuntimeState::Paused;
    // A paused program that an operator runs by hold-to-run must not continue automatically.
    if (!permitted || (paused && script != nullptr && script->held)) {
        endActive(StopCause::ControlLost, data.hostNs);
    }
    status_.executing = permitted && script != nullptr && data.runtimeState == RuntimeState::Playing;
}

void ControlLoop::leave(ControlLoss loss, StopCause cause, std::int64_t nowNs) {
    // This order and the opposite order at the start of motions (confirmControl) ensure that no motion is
    // missed.
    inControl_.exchange(false, std::memory_order_acq_rel);
    endActive(cause, nowNs);
    forcePermitted_.exchange(false, std::memory_order_acq_rel);
    status_.inControl = false;
    status_.executing = false;
    status_.loss = loss;
}

void ControlLoop::endActive(StopCause cause, std::int64_t nowNs) {
    const MotionId motion = mailbox_.epoch().activeMotion();
    if (motion != kNoMotion) {
        mailbox_.end(motion, cause, nowNs);
    }
}

void ControlLoop::endDelayed(StopCause cause, MotionDelay::Kind kind, std::int64_t measuredNs,
                             std::int64_t nowNs) {
    const MotionId motion = mailbox_.epoch().activeMotion();
    if (motion == kNoMotion) {
        return;
    }
    // The timeout of the robot does not depend on the options of this controller.
    const std::int64_t limitNs =
        kind == MotionDelay::Kind::Heartbeat ? std::max(kHoldTimeNs, followedTimeoutNs_) : dataTimeoutNs();
    // Store the delay before ending the motion, so that a waiting caller finds it.
    delay_.store({motion, cause, kind, measuredNs, limitNs, stalledNs_});
    mailbox_.end(motion, cause, nowNs);
}

void ControlLoop::noteLook(std::int64_t nowNs) {
    stalledNs_ = std::max(stalledNs_, nowNs - lookedNs_);
    lookedNs_ = nowNs;
}

// Longest time between two consecutive packages, from the stored send times.
std::int64_t ControlLoop::longestSendGapNs() const {
    const auto sent = static_cast<std::size_t>(sequence_ - kBeforeFirstSequence);
    std::int64_t longest = 0;
    for (std::size_t back = 0; back + 1 < std::min(sent, kSentMemory); ++back) {
        const auto newer = static_cast<std::size_t>(sequence_) - back;
        longest = std::max(longest, sentNs_[newer % kSentMemory] - sentNs_[(newer - 1) % kSentMemory]);
    }
    return longest;
}

void ControlLoop::compose(const Feedback& data, Command& command) {
    if (endRequested_.load(std::memory_order_acquire)) {
        endActive(StopCause::ControlLost, data.hostNs);
        command.kind = ScriptCommand::End;
        return;
    }
    const MotionCommand* motion = mailbox_.active(data.hostNs);
    if (motion == nullptr) {
        return;
    }
    if (motion->id != followed_) {
        noteEnded(data.hostNs);
        followed_ = motion->id;
        followsScript_ = motion->kind == MotionCommand::Kind::Script;
        followedHoldToRun_ = motion->kind != MotionCommand::Kind::Program && !followsScript_;
        followedTcp_ = data.tcpOffset;
        followedForce_ = data.tcpForce.value_or(Eigen::Vector3d::Zero());
        pressed_ = 0;
        followedTimeoutNs_ = std::chrono::nanoseconds(motion->heartbeatTimeout).count();
        status_.limiter = motion->limiter;
        // The measured motion was replaced before it reached standstill.
        meter_.cancel();
    }
    if (motion->kind == MotionCommand::Kind::Jog) {
        composeJog(*motion, data, command);
    } else if (followsScript_) {
        command.choice = motion->choice;
        command.values = motion->target;
    } else {
        composeProgram(*motion, data, {period_, true, evenNs_, ageNs_}, command);
    }
}

void ControlLoop::composeProgram(const MotionCommand& motion, const Feedback& data, const Occasion& occasion,
                                 Command& command) {
    const MotionCommand* from = &motion;
    MotionCommand hooked;
    hookInUse_.store(true);
    CycleHook* const hook = hook_.load();
    if (hook != nullptr && hook->motion() == motion.id) {
        hooked = motion;
        from = &hooked;
        if (!hook->cycle(data, occasion, hooked)) {
            mailbox_.end(motion.id, StopCause::Completed, data.hostNs);
        }
        composedNs_ = std::max(composedNs_, hook->endedNs());
    }
    hookInUse_.store(false);
    switch (from->kind) {
        case MotionCommand::Kind::MoveJ:
            command.kind = ScriptCommand::MoveJ;
            break;
        case MotionCommand::Kind::MoveL:
            command.kind = ScriptCommand::MoveL;
            break;
        default:
            command.kind = static_cast<ScriptCommand>(from->program);
            break;
    }
    command.choice = from->choice;
    if (command.kind == ScriptCommand::Torque && from->choice > 0) {
        command.choice = inMillimetres(speedCap_.load());
    }
    command.values = from->target;
    command.speed = from->speed;
    command.acceleration = from->acceleration;
    command.rotationAcceleration = from->rotationAcceleration;
    command.rotation = from->rotation;
    command.heartbeatTimeoutMs = static_cast<std::int32_t>(from->heartbeatTimeout.count());
}

bool ControlLoop::feelsContact(const JogTarget& target, const Feedback& data) {
    if (target.contactForce <= 0) {
        return false;
    }
    if (!data.tcpForce) {
        return true;  // without force data, contact detection is impossible
    }
    // A single packet may be noise. In three packets at 500 Hz, the arm moves 0.12 mm at 20 mm/s.
    constexpr int kPackages = 3;
    const bool pressed = (*data.tcpForce - followedForce_).norm() > target.contactForce;
    pressed_ = pressed ? pressed_ + 1 : 0;
    return pressed_ >= kPackages;
}

void ControlLoop::composeJog(const MotionCommand& motion, const Feedback& data, Command& command) {
    const JogTarget& target = motion.jog;
    if (feelsContact(target, data)) {
        mailbox_.end(motion.id, StopCause::Contact, data.hostNs);
        return;
    }
    limiter_.setSpeedCap(speedCap_.load());
    status_.limiter = limiter_.limit(target, data.q, data.tcpPose, {data.qd, check_.newest().get()});
    const double scale = status_.limiter.scale;
    if (scale <= 0) {
        mailbox_.end(motion.id, StopCause::LimitReached, data.hostNs);
        return;
    }
    // Decelerate as for a stop. With a lower deceleration, the arm would brake too late before a limit.
    const bool brake = status_.limiter.brake;
    bool slowing = false;
    if (target.kind == JogTarget::Kind::Cartesian) {
        command.kind = ScriptCommand::JogCartesian;
        const Vector6 twist = target.twist.vector() * scale;
        std::copy_n(twist.data(), command.values.size(), command.values.begin());
        slowing = brake || data.tcpSpeed.linear.norm() > twist.head<3>().norm() + kStillTcpSpeed;
        command.acceleration = slowing ? limits_.jogDeceleration : limits_.jogAcceleration;
        slowing = brake || data.tcpSpeed.angular.norm() > twist.tail<3>().norm() + kStillJointSpeed;
        command.rotationAcceleration = slowing ? limits_.jointDeceleration : limits_.jointAcceleration;
    } else {
        command.kind = ScriptCommand::JogJoints;
        const Vector6 qd = target.qd.values * scale;
        std::copy_n(qd.data(), command.values.size(), command.values.begin());
        slowing = brake || fastest(data.qd) > qd.cwiseAbs().maxCoeff() + kStillJointSpeed;
        command.acceleration = slowing ? limits_.jointDeceleration : limits_.jointAcceleration;
    }
    command.choice = static_cast<std::int32_t>(target.frame);
    const Eigen::Vector3d& rotation = target.T_base_frame.rotation;
    command.rotation = {rotation.x(), rotation.y(), rotation.z()};
}

// Records the end of the current motion, if it has ended. The epoch contains the cause and the time.
void ControlLoop::noteEnded(std::int64_t nowNs) {
    const Epoch& epoch = mailbox_.epoch();
    if (followed_ == kNoMotion || epoch.isActive(followed_)) {
        return;
    }
    const StopCause cause = epoch.state(followed_).cause;
    status_.lastMotion = followed_;
    status_.lastCause = cause;
    status_.executing = false;
    if (cause != StopCause::LimitReached) {
        status_.limiter = {};
    }
    // Replacement or completion of a motion is not a stop. A motion that ends because of a missing refresh or
    // late data also ends force mode.
    if (cause == StopCause::EventLoopStalled || cause == StopCause::DataStale ||
        cause == StopCause::LinkLost) {
        forcePermitted_.exchange(false, std::memory_order_acq_rel);
    }
    if (cause != StopCause::Superseded && cause != StopCause::Completed) {
        meter_.begin(cause, std::min(epoch.endedNs(followed_), nowNs));
    }
    followed_ = kNoMotion;
    followsScript_ = false;
}

void ControlLoop::publish() {
    status_.motion = mailbox_.epoch().activeMotion();
    status_.epoch = mailbox_.epoch().current();
    status_.forceMode = forcePermitted_.load(std::memory_order_acquire);
    status_.moving = meter_.isMoving();
    status_.lastStop = meter_.last();
    status_.lastUnmeasured = meter_.lastUnmeasured();
    published_.store(status_);
}

// Last step: sets the epoch and the sequence number. The command of a motion that has just ended is not sent.
// An idle command must not carry the epoch of a motion that has just started, because the robot would then
// never execute this motion.
void ControlLoop::seal(Command& command, std::int64_t nowNs) {
    const bool moves = command.kind != ScriptCommand::Idle && command.kind != ScriptCommand::End;
    if (moves && mailbox_.epoch().isActive(followed_)) {
        command.epoch = static_cast<std::int32_t>(followed_);
        sentMotion_ = followed_;
    } else {
        const ScriptCommand kind = moves ? ScriptCommand::Idle : command.kind;
        const std::int32_t gate = command.choice;
        const std::array<double, 6> change = command.values;
        const std::uint64_t dead = mailbox_.epoch().expiredUpTo();
        const Brake brake = mailbox_.brake(dead);
        command = {};
        command.kind = kind;
        command.choice = static_cast<std::int32_t>(brake.along);
        command.acceleration = brake.deceleration;
        command.rotationAcceleration = brake.rotationDeceleration;
        command.epoch = static_cast<std::int32_t>(dead);
        sentMotion_ = followsScript_ && mailbox_.epoch().isActive(followed_) ? followed_ : kNoMotion;
        if (sentMotion_ != kNoMotion) {
            command.choice = gate;
            command.values = change;
        }
    }
    command.request = request_.newest();
    if (followsScript_ && sentMotion_ != kNoMotion) {
        // No control program that could read a request is running.
        command.request.whole = wholeOf(command.values[0]);
    }
    command.forcePermitted = sentForce_ = forcePermitted_.load(std::memory_order_acquire);
    command.speedFraction = data_.speedFraction;
    constexpr std::int32_t kWrap = 0x3fffffff;
    sequence_ = sequence_ >= kWrap ? kBeforeFirstSequence + 1 : sequence_ + 1;
    command.mayFinish = mayFinish_.load(std::memory_order_acquire);
    if (command.mayFinish && finishSequence_ == 0) {
        finishSequence_ = sequence_;
    }
    command.sequence = sequence_;
    command.session = session_;
    if (command.forcePermitted || command.kind == ScriptCommand::Freedrive ||
        command.kind == ScriptCommand::Teach) {
        yieldedNs_ = nowNs;
    }
    sentNs_[static_cast<std::size_t>(sequence_) % kSentMemory] = nowNs;
    if (unansweredSinceNs_ == 0) {
        unansweredSinceNs_ = nowNs;
    }
}

}  // namespace tiller::control
