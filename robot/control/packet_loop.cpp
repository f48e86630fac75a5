// SPDX-License-Identifier: MIT
#include "robot/control/packet_loop.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <thread>

#include "robot/control/detail/controller_private.h"
#include "robot/control/detail/setpoint_command.h"

namespace tiller::control {

const receive::Sample CycleState::kNoPacket;

namespace {

template <class Target, class Parameters>
class Cycle final : public CycleHook {
public:
    Cycle(const CycleCallback<Target>& callback, const SetpointRules& rules, const Parameters& parameters,
          MotionId motion, const Clock& clock, Pacing pacing, std::int64_t awakeNs)
        : callback_(callback)
        , rules_(rules)
        , parameters_(parameters)
        , motion_(motion)
        , clock_(clock)
        , isEven_(pacing == Pacing::Even && clock.runsByItself())
        , awakeNs_(awakeNs) {}

    MotionId motion() const override { return motion_; }

    bool cycle(const Feedback& data, const Occasion& occasion, MotionCommand& target) override {
        const bool served = occasion.fresh && isServed(data, occasion.period);
        const bool goesOn = served ? repeat(occasion.period, target) : run(data, occasion, target);
        if (occasion.fresh) {
            packetAt_ = data.timestamp;
        }
        return goesOn;
    }

    std::int64_t endedNs() const override { return endedNs_; }

    // If the intervals between packets stay longer than a period or the robot stalls, cycles follow the
    // packets instead of their predicted times. Missed cycles are not repeated.
    std::int64_t dueNs(const realtime::ArrivalPace& pace) const override {
        if (!isEven_ || report.cycles == 0 || !pace.isSettled() || staleInARow_ >= kMaxConsecutive) {
            return kNoCycleDue;
        }
        const auto periodNs = static_cast<std::int64_t>(period_ * 1e9);
        const std::int64_t due = pace.expectedNs(servedAt_ + period_);
        return clock_.nowNs() - due > periodNs / 2 ? kNoCycleDue : due;
    }

    /// Sleep time for a thread that waits for the end of the loop, at least 1 ms. The thread then wakes up
    /// just after a cycle. At another time, the thread, which may have a real-time priority, would delay the
    /// next cycle.
    /// Threads  any
    std::chrono::nanoseconds quietIn() const {
        return std::chrono::nanoseconds(std::max(quietNs_.load() - clock_.nowNs(), kNsPerMs));
    }

    /// The last call that took so long that the robot may have stopped because of the missing heartbeat,
    /// including the round trip.
    struct LongCall {
        std::int64_t tookNs = 0;
        std::int64_t endedNs = 0;
    };
    const LongCall& longCall() const { return longCall_; }
    double period() const { return period_; }

    CycleReport report;
    Error error;

private:
    static constexpr int kMaxConsecutive = 5;  ///< number of cycles without a packet
    /// Approximate interval between two checks by a waiting thread.
    static constexpr std::int64_t kLookNs = 9 * kNsPerMs;

    /// True if a cycle has already run without this packet.
    bool isServed(const Feedback& data, double period) const {
        return report.cycles > 0 && data.timestamp > packetAt_ && data.timestamp < servedAt_ + period / 2;
    }

    bool repeat(double period, MotionCommand& target) {
        fill(target, parameters_, period);
        fill(target, last_);
        return true;
    }

    bool run(const Feedback& data, const Occasion& occasion, MotionCommand& target) {
        const auto [period, isNew, evenNs, ageNs] = occasion;
        const double time = isNew ? data.timestamp : servedAt_ + period;
        const std::int64_t beginNs = begin(isNew, evenNs, period);
        note(data, time, beginNs, isNew, period);
        CycleState state;
        state.cycle = report.cycles - 1;
        state.age = static_cast<double>(ageNs + beginNs - data.hostNs) * 1e-9;
        state.fresh = isNew && state.age <= 2 * period;
        state.missed = report.missed;
        state.time = time - beganAt_;
        state.period = period;
        state.hostNs = data.hostNs;
        state.beginNs = beginNs;
        state.q = data.q;
        state.qd = data.qd;
        state.tcpPose = data.tcpPose;
        state.tcpSpeed = data.tcpSpeed;
        state.speedFraction = data.speedFraction;
        state.speedScaling = data.speedScaling;
        state.packet = data.sample;

        const std::optional<Target> wanted = ask(state);
        endedNs_ = clock_.nowNs();
        callNs_ = endedNs_ - beginNs;
        report.calls.add(callNs_);
        if (callNs_ > std::chrono::nanoseconds(kHoldTime).count() / 2) {
            longCall_ = {callNs_, endedNs_};
        }
        report.overruns += static_cast<double>(callNs_) > period * 1e9 ? 1 : 0;
        if (!wanted || error.code != ErrorCode::None) {
            return false;
        }
        error = rules_.check(*wanted);
        fill(target, parameters_, period);
        if constexpr (std::is_same_v<Parameters, ServoParameters>) {
            if (error.code == ErrorCode::None) {
                const Target from = place(data);
                error = rules_.step(from, *wanted, stepTime(time - targetAt_, target.speed));
            }
        }
        if (error.code != ErrorCode::None) {
            return false;
        }
        last_ = *wanted;
        targetAt_ = time;
        fill(target, last_);
        return true;
    }

    /// Reference for checking the next target: the previous target, or initially the arm position.
    Target place(const Feedback& data) {
        if (report.cycles > 1) {
            return last_;
        }
        targetAt_ = data.timestamp;
        if constexpr (std::is_same_v<Target, Pose>) {
            return data.tcpPose;
        } else {
            return data.q;
        }
    }

    // An exception in the control thread would terminate the process.
    std::optional<Target> ask(const CycleState& state) {
        QString what;
        try {
            return callback_(state);
        } catch (const std::exception& thrown) {
            what = QString::fromLocal8Bit(thrown.what());
        } catch (...) {
            what = QStringLiteral("unknown");
        }
        error = {ErrorCode::Stopped, QStringLiteral("run a packet loop"),
                 QStringLiteral("the callback threw an exception: ") + what};
        return {};
    }

    // The result is not sent if the motion has ended: see ControlLoop::seal(). After a long callback, there
    // is no busy wait, so that other threads on this CPU can run, e.g. to stop the arm.
    std::int64_t begin(bool fresh, std::int64_t evenNs, double period) {
        if (isEven_ && fresh) {
            const bool isLong = static_cast<double>(callNs_) > period * 1e9 / 4;
            clock_.waitUntil(evenNs, isLong ? kWakeUpNs : awakeNs_);
        }
        return clock_.nowNs();
    }

    void note(const Feedback& data, double time, std::int64_t beginNs, bool fresh, double period) {
        if (report.cycles++ == 0) {
            beganAt_ = time;
        } else {
            const double steps = std::round((time - servedAt_) / period);
            report.missed += steps > 1 ? static_cast<std::uint64_t>(steps) - 1 : 0;
            const std::int64_t apart = beginNs - previousNs_;
            report.intervals.add(apart);
            constexpr double kLate = 1.5;
            report.late += static_cast<double>(apart) > kLate * period * 1e9 ? 1 : 0;
        }
        report.stale += fresh ? 0 : 1;
        if (fresh) {
            report.ages.add(beginNs - data.hostNs);
        }
        staleInARow_ = fresh ? 0 : staleInARow_ + 1;
        servedAt_ = time;
        period_ = period;
        previousNs_ = beginNs;
        const auto periodNs = static_cast<std::int64_t>(period * 1e9);
        quietNs_.store(beginNs + periodNs / 4 + std::max<std::int64_t>(kLookNs / periodNs, 1) * periodNs);
    }

    const CycleCallback<Target>& callback_;
    const SetpointRules& rules_;
    const Parameters& parameters_;
    MotionId motion_;
    const Clock& clock_;
    bool isEven_;
    std::int64_t awakeNs_;  ///< busy wait before a cycle
    Target last_;
    double targetAt_ = 0;  ///< robot time of the last target [s]
    double beganAt_ = 0;
    double packetAt_ = 0;  ///< timestamp of the newest packet
    double servedAt_ = 0;  ///< packet timestamp of the last cycle
    double period_ = 0;
    int staleInARow_ = 0;
    std::int64_t previousNs_ = 0;
    std::int64_t endedNs_ = 0;
    LongCall longCall_;
    std::int64_t callNs_ = 0;  ///< duration of the last call
    std::atomic<std::int64_t> quietNs_{0};
};

// Busy wait before a packet, because other threads on the CPU may delay the wake-up of a sleeping thread by
// milliseconds. Without a real-time priority, the scheduler would penalize a busy wait.
std::int64_t awakeNs(const Controller::Private& d) {
    constexpr std::int64_t kFromArrivalNs = kNsPerMs;  // maximum delay added by ArrivalPace
    return d.options.priority > 0 && d.loop.status().priorityGranted ? kFromArrivalNs : kWakeUpNs;
}

/// Error if the loop ended because the callback was too slow.
Error slowCallback(std::int64_t tookNs, const CycleReport& report, double period) {
    return {ErrorCode::Stopped, QStringLiteral("run a packet loop"),
            QStringLiteral("one call of the callback took %1 ms, with a control period of %2 ms; the robot "
                           "stops after %3 ms without a heartbeat. %4 of %5 calls took longer than a period")
                .arg(static_cast<double>(tookNs) * 1e-6, 0, 'f', 1)
                .arg(1e3 * period, 0, 'f', 0)
                .arg(kHoldTime.count())
                .arg(report.overruns)
                .arg(report.cycles)};
}

template <class Stream, class Target, class Parameters>
Result<void> run(Controller& controller, const Result<Stream>& stream, const CycleCallback<Target>& callback,
                 const Parameters& parameters, Pacing pacing, const Deadline& deadline, CycleReport* report) {
    if (!stream) {
        return stream.error();
    }
    const Motion motion = stream->motion();
    const SetpointRules rules = rulesOf(controller);
    auto& d = ControllerAccess::of(controller);
    Cycle<Target, Parameters> cycle(callback, rules, parameters, motion.id(), *d.options.clock, pacing,
                                    awakeNs(d));
    d.loop.setHook(&cycle);
    while (motion.isActive() && !deadline.hasExpired()) {
        std::this_thread::sleep_for(std::min<std::chrono::nanoseconds>(deadline.nextPoll(), cycle.quietIn()));
    }
    Result<void> ended = motion.wait(deadline);
    motion.cancel();
    d.loop.setHook(nullptr);
    if (report != nullptr) {
        *report = cycle.report;
        report->fastWakeUps = d.loop.status().fastWakeUps;
        report->motion = motion;
    }
    if (cycle.error.code != ErrorCode::None) {
        return cycle.error;
    }
    // Use the recorded end times, because this thread checks later.
    const auto& last = cycle.longCall();
    const bool endedMotion =
        last.tookNs > 0 && d.mailbox.epoch().endedNs(motion.id()) - last.endedNs < kNsPerSecond / 2;
    if (!ended && ended.error().code == ErrorCode::LinkLost && endedMotion) {
        return slowCallback(last.tookNs, cycle.report, cycle.period());
    }
    return ended;
}

}  // namespace

Result<void> PacketLoop::servoJ(const CycleCallback<JointPositions>& callback,
                                const ServoParameters& parameters, const Deadline& deadline,
                                CycleReport* report) {
    return run(*controller_, Motions(*controller_).startServoJ(parameters, Holding::Free), callback,
               parameters, pacing_, deadline, report);
}

Result<void> PacketLoop::servoL(const CycleCallback<Pose>& callback, const ServoParameters& parameters,
                                const Deadline& deadline, CycleReport* report) {
    return run(*controller_, Motions(*controller_).startServoL(parameters, Holding::Free), callback,
               parameters, pacing_, deadline, report);
}

Result<void> PacketLoop::speedJ(const CycleCallback<JointVelocities>& callback,
                                const SpeedParameters& parameters, const Deadline& deadline,
                                CycleReport* report) {
    return run(*controller_, Motions(*controller_).startSpeedJ(parameters, Holding::Free), callback,
               parameters, pacing_, deadline, report);
}

Result<void> PacketLoop::speedL(const CycleCallback<Twist>& callback, const SpeedParameters& parameters,
                                const Deadline& deadline, CycleReport* report) {
    return run(*controller_, Motions(*controller_).startSpeedL(parameters, Holding::Free), callback,
               parameters, pacing_, deadline, report);
}

Result<void> PacketLoop::torque(const CycleCallback<JointTorques>& callback,
                                const TorqueParameters& parameters, const Deadline& deadline,
                                CycleReport* report) {
    return run(*controller_, Motions(*controller_).startTorque(parameters, Holding::Free), callback,
               parameters, pacing_, deadline, report);
}

}  // namespace tiller::control
