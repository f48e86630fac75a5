// SPDX-License-Identifier: MIT
#include "robot/control/packet_loop.h"

#include <chrono>
#include <cmath>
#include <exception>

#include "robot/control/controller_private.h"
#include "robot/control/setpoint_command.h"

namespace tiller::control {

namespace {

template <class Target, class Parameters>
class Cycle final : public CycleHook {
public:
    Cycle(const CycleCallback<Target>& callback, const SetpointRules& rules, const Parameters& parameters,
          MotionId motion)
        : callback_(callback), rules_(rules), parameters_(parameters), motion_(motion) {}

    MotionId motion() const override { return motion_; }

    bool cycle(const Feedback& data, double period, MotionCommand& target) override {
        note(data, period);
        CycleState state;
        state.cycle = report.cycles - 1;
        state.missed = report.missed;
        state.time = data.timestamp - beganAt_;
        state.period = period;
        state.hostNs = data.hostNs;
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
                error = rules_.step(from, *wanted, stepTime(data.timestamp - targetAt_, target.speed));
            }
        }
        if (error.code != ErrorCode::None) {
            return false;
        }
        last_ = *wanted;
        targetAt_ = data.timestamp;
        fill(target, last_);
        return true;
    }

    CycleReport report;
    Error error;

private:
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
    void note(const Feedback& data, double period) {
        if (report.cycles++ == 0) {
            beganAt_ = data.timestamp;
        } else {
            const double steps = std::round((data.timestamp - previousAt_) / period);
            report.missed += steps > 1 ? static_cast<std::uint64_t>(steps) - 1 : 0;
            const std::int64_t apart = data.hostNs - previousNs_;
            report.intervals.add(apart);
            constexpr double kLate = 1.5;
            report.late += static_cast<double>(apart) > kLate * period * 1e9 ? 1 : 0;
        }
        previousAt_ = data.timestamp;
        previousNs_ = data.hostNs;
    }

    const CycleCallback<Target>& callback_;
    const SetpointRules& rules_;
    const Parameters& parameters_;
    MotionId motion_;
    Target last_;
    double targetAt_ = 0;  ///< by the robot's clock [s]
    double beganAt_ = 0;
    double previousAt_ = 0;
    std::int64_t previousNs_ = 0;
};

template <class Stream, class Target, class Parameters>
Result<void> run(Controller& controller, const Result<Stream>& stream, const CycleCallback<Target>& callback,
                 const Parameters& parameters, const Deadline& deadline, CycleReport* report) {
    if (!stream) {
        return stream.error();
    }
    const Motion motion = stream->motion();
    const SetpointRules rules = rulesOf(controller);
    auto& d = ControllerAccess::of(controller);
    Cycle<Target, Parameters> cycle(callback, rules, parameters, motion.id());
    d.loop.setHook(&cycle);
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
               parameters, deadline, report);
}

Result<void> PacketLoop::servoL(const CycleCallback<Pose>& callback, const ServoParameters& parameters,
                                const Deadline& deadline, CycleReport* report) {
    return run(*controller_, Motions(*controller_).startServoL(parameters, Holding::Free), callback,
               parameters, deadline, report);
}

Result<void> PacketLoop::speedJ(const CycleCallback<JointVelocities>& callback,
                                const SpeedParameters& parameters, const Deadline& deadline,
                                CycleReport* report) {
    return run(*controller_, Motions(*controller_).startSpeedJ(parameters, Holding::Free), callback,
               parameters, deadline, report);
}

Result<void> PacketLoop::speedL(const CycleCallback<Twist>& callback, const SpeedParameters& parameters,
                                const Deadline& deadline, CycleReport* report) {
    return run(*controller_, Motions(*controller_).startSpeedL(parameters, Holding::Free), callback,
               parameters, deadline, report);
}

}  // namespace tiller::control
