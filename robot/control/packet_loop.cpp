// SPDX-License-Identifier: MIT
#include "robot/control/packet_loop.h"

#include <chrono>
#include <cmath>
#include <exception>
#include <thread>

#include "robot/control/controller_private.h"
#include "robot/control/setpoint_command.h"
#include "robot/realtime/arrival_pace.h"

namespace tiller::control {

namespace {

template <class Target, class Parameters>
class Cycle final : public CycleHook {
public:
    Cycle(const CycleCallback<Target>& callback, const SetpointRules& rules, const Parameters& parameters,
          MotionId motion, const Clock& clock, Pacing pacing)
        : callback_(callback)
        , rules_(rules)
        , parameters_(parameters)
        , motion_(motion)
        , clock_(clock)
        , pacing_(pacing) {}

    MotionId motion() const override { return motion_; }

    bool cycle(const Feedback& data, bool fresh, double period, MotionCommand& target) override {
        const bool goesOn =
            fresh && isServed(data, period) ? repeat(data, period, target) : run(data, fresh, period, target);
        if (fresh) {
            packetAt_ = data.timestamp;
        }
        return goesOn;
    }

    std::int64_t beganNs() const override { return previousNs_; }

    // A path that has become longer for good, or a robot that stalls, is not to be outrun: the packets lead.
    // Nor is anything made up for that this thread overslept.
    std::int64_t dueNs() const override {
        if (!pace_ || !pace_->isSettled() || staleInARow_ >= kMostInARow) {
            return kNoCycleDue;
        }
        const auto periodNs = static_cast<std::int64_t>(period_ * 1e9);
        const std::int64_t due = pace_->expectedNs(servedAt_ + period_);
        return clock_.nowNs() - due > periodNs / 2 ? kNoCycleDue : due;
    }

    CycleReport report;
    Error error;

private:
    static constexpr int kMostInARow = 5;  ///< cycles without their packets

    /// Its cycle has already been run without it.
    bool isServed(const Feedback& data, double period) const {
        return report.cycles > 0 && data.timestamp > packetAt_ && data.timestamp < servedAt_ + period / 2;
    }

    /// Time stamps that stand still, go back or leap are no pace to keep.
    bool leaps(const Feedback& data) const {
        constexpr double kFurthest = 1;  // [s]
        const double step = data.timestamp - packetAt_;
        return !(step > 0 && step < kFurthest);
    }

    bool repeat(const Feedback& data, double period, MotionCommand& target) {
        if (pace_) {
            pace_->due(data.hostNs, data.timestamp);
        }
        fill(target, parameters_, period);
        fill(target, last_);
        return true;
    }

    bool run(const Feedback& data, bool fresh, double period, MotionCommand& target) {
        const double time = fresh ? data.timestamp : servedAt_ + period;
        const std::int64_t beginNs = begin(data, fresh, period);
        note(data, time, beginNs, fresh, period);
        CycleState state;
        state.cycle = report.cycles - 1;
        state.fresh = fresh;
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

        const auto before = std::chrono::steady_clock::now();
        const std::optional<Target> wanted = ask(state);
        const auto took = std::chrono::steady_clock::now() - before;
        report.calls.add(std::chrono::nanoseconds(took).count());
        if (std::chrono::duration<double>(took).count() > period) {
            ++report.overruns;
        }
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

    /// What the next target is judged from: the one before, at first the arm itself.
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

    // In the control thread an exception would end the whole process.
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
    // What is ended meanwhile is not sent any more: see ControlLoop::seal().
    std::int64_t begin(const Feedback& data, bool fresh, double period) {
        if (pacing_ == Pacing::Even && clock_.runsByItself() && fresh) {
            if (!pace_ || staleInARow_ >= kMostInARow || leaps(data)) {
                pace_.emplace(period);
            }
            clock_.waitUntil(pace_->due(data.hostNs, data.timestamp));
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
    }

    const CycleCallback<Target>& callback_;
    const SetpointRules& rules_;
    const Parameters& parameters_;
    MotionId motion_;
    const Clock& clock_;
    Pacing pacing_;
    std::optional<realtime::ArrivalPace> pace_;
    Target last_;
    double targetAt_ = 0;  ///< by the robot's clock [s]
    double beganAt_ = 0;
    double packetAt_ = 0;  ///< time stamp of the newest packet
    double servedAt_ = 0;  ///< time stamp of the packet whose cycle was the last
    double period_ = 0;
    int staleInARow_ = 0;
    std::int64_t previousNs_ = 0;
};

template <class Stream, class Target, class Parameters>
Result<void> run(Controller& controller, const Result<Stream>& stream, const CycleCallback<Target>& callback,
                 const Parameters& parameters, Pacing pacing, const Deadline& deadline, CycleReport* report) {
    if (!stream) {
        return stream.error();
    }
    const Motion motion = stream->motion();
    const SetpointRules rules = rulesOf(controller);
    auto& d = ControllerAccess::of(controller);
    Cycle<Target, Parameters> cycle(callback, rules, parameters, motion.id(), *d.options.clock, pacing);
    d.loop.setHook(&cycle);
    // A waiter that looks up every millisecond, as wait() does, at real-time priority perhaps, gets in the
    // way of the cycles.
    while (motion.isActive() && !deadline.hasExpired()) {
        std::this_thread::sleep_for(deadline.nextPoll());
    }
    Result<void> ended = motion.wait(deadline);
    motion.cancel();
    d.loop.setHook(nullptr);
    if (report != nullptr) {
        *report = cycle.report;
        report->motion = motion;
    }
    if (cycle.error.code != ErrorCode::None) {
        return cycle.error;
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

}  // namespace tiller::control
