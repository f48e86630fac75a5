// SPDX-License-Identifier: MIT
#pragma once

// A simulated robot and a controller on one virtual clock, with real sockets and real threads, but not in
// real time. Each step is one control period. The next step begins only after the controller's reply has
// arrived.

#include <QTest>
#include <algorithm>
#include <atomic>
#include <functional>
#include <optional>
#include <thread>

#include "robot/control/motions.h"
#include "robot/core/clock.h"
#include "robot/simulator/simulator.h"

namespace tiller::test {

inline constexpr double kDeg = 3.14159265358979323846 / 180;

/// A clock that is advanced manually. It can behave like a clock that runs automatically.
class CellClock final : public Clock {
public:
    std::int64_t nowNs() const override {
        if (std::this_thread::get_id() == counted_.load(std::memory_order_acquire)) {
            asked_.fetch_add(1, std::memory_order_acq_rel);
        }
        return clock_.nowNs();
    }
    /// From now on, asked() counts how often `thread` reads the time.
    void count(std::thread::id thread) { counted_.store(thread, std::memory_order_release); }
    std::uint64_t asked() const { return asked_.load(std::memory_order_acquire); }
    bool runsByItself() const override { return pretending_; }
    void waitUntil(std::int64_t ns, std::int64_t awakeNs) const override {
        const std::int64_t left = ns - clock_.nowNs();
        shortestNs_ = std::min(shortestNs_.load(), left);
        longestNs_ = std::max(longestNs_.load(), left);
        awakeNs_ = awakeNs;
    }
    /// The shortest wait that was requested [ns].
    std::int64_t shortestNs() const { return shortestNs_; }
    std::int64_t longestNs() const { return longestNs_; }
    std::int64_t awakeNs() const { return awakeNs_; }
    void advanceNs(std::int64_t ns) { clock_.advanceNs(ns); }
    /// Makes the clock report that it runs automatically. Timed actions then happen at their time even though
    /// no thread waits for them.
    void pretendToRun() { pretending_ = true; }

private:
    VirtualClock clock_;
    std::atomic<bool> pretending_{false};
    std::atomic<std::thread::id> counted_{};
    mutable std::atomic<std::uint64_t> asked_{0};
    mutable std::atomic<std::int64_t> shortestNs_{kNsPerSecond};  // only one thread waits
    mutable std::atomic<std::int64_t> longestNs_{0};
    mutable std::atomic<std::int64_t> awakeNs_{0};
};

class Cell {
public:
    explicit Cell(std::function<void(simulator::SimulatorOptions&)> adjust = {},
                  control::RegisterRange range = control::RegisterRange::Upper,
                  const control::MotionLimits& limits = {})
        : robot(robotOptions(adjust)) {
        if (const auto started = robot.start(); !started) {
            qFatal("%s", qPrintable(started.error().toString()));
        }
        control::ControllerOptions options;
        options.host = robot.listenAddress();
        options.primaryPort = robot.ports().primary;
        options.rtdePort = robot.ports().rtde;
        options.clock = &clock;
        options.registers = range;
        options.limits = limits;
        options.priority = 0;
        controller = std::make_unique<control::Controller>(options);
    }

    control::Motions motions() { return control::Motions(*controller); }

    /// Takes control while time advances.
    Result<void> takeControl() {
        Result<void> result;
        std::atomic<bool> done{false};
        const std::uint64_t before = robot.inputPackages();
        std::thread taking([&] {
            result = controller->takeControl(Deadline::after(std::chrono::seconds(20)));
            done = true;
        });
        while (!done) {
            const std::uint64_t inputs = robot.inputPackages();
            tick();
            // A program without a heartbeat ends after 5 s, and the robot disconnects a client that is not
            // reading, even if only a thread is late. Therefore, time advances no faster than real time until
            // the controller replies, and then waits for its replies.
            const bool answers = inputs > before || robot.truth().runtimeState == RuntimeState::Playing;
            robot.waitForInputPackages(inputs + 1,
                                       Deadline::after(std::chrono::milliseconds(answers ? 20 : 2)));
        }
        taking.join();
        settle();
        return result;
    }

    /// Runs a function that waits for the robot while time advances.
    template <class Call>
    auto during(Call call) {
        std::optional<decltype(call())> result;
        std::atomic<bool> done{false};
        std::thread caller([&] {
            result.emplace(call());
            done = true;
        });
        while (!done) {
            const std::uint64_t inputs = robot.inputPackages();
            tick();
            if (everyTick) {
                everyTick();
            }
            // While in control, the controller replies to each package. Watchdogs use robot time, which must
            // not run ahead of a late control thread.
            const bool answers = controller->status().inControl;
            robot.waitForInputPackages(inputs + 1,
                                       Deadline::after(std::chrono::milliseconds(answers ? 100 : 20)));
        }
        caller.join();
        return *result;
    }

    void release() {
        std::atomic<bool> done{false};
        std::thread releasing([&] {
            controller->release();
            done = true;
        });
        while (!done) {
            const std::uint64_t inputs = robot.inputPackages();
            tick();
            robot.waitForInputPackages(inputs + 1, Deadline::after(std::chrono::milliseconds(5)));
        }
        releasing.join();
    }

    /// Advances time by control periods of 2 ms. Returns false if the controller stopped replying.
    bool step(int ticks = 1) {
        for (int i = 0; i < ticks; ++i) {
            const Answers before = answers();
            tick();
            if (everyTick) {
                everyTick();
            }
            if (!waitForAnswer(before)) {
                return false;
            }
        }
        return true;
    }
    /// The replies of the controller so far.
    struct Answers {
        /// True if the controller replies to new data: it is in control, or lost control because of old data.
        bool expected = false;
        double time = 0;           ///< ControllerStatus::answeredTime
        std::uint64_t inputs = 0;  ///< number of packages that the robot has received
    };
    Answers answers() const {
        const auto status = controller ? controller->status() : control::ControllerStatus();
        const bool expected = status.inControl || status.loss == control::ControlLoss::DataStale;
        return {expected, status.answeredTime, robot.inputPackages()};
    }
    /// Waits until data newer than `before` have been answered and the reply has arrived. Returns false after
    /// 20 s. The next package from the controller is not necessarily the reply, because the controller also
    /// sends other packages: a stop, or a setpoint between two packages. If the test treated such a package
    /// as the reply, it would be one package ahead.
    bool waitForAnswer(const Answers& before) {
        const Deadline deadline = Deadline::after(std::chrono::seconds(20));
        while (before.expected && controller->status().answeredTime == before.time) {
            if (deadline.hasExpired()) {
                return false;
            }
            robot.drainSockets();
        }
        return robot.waitForInputPackages(before.inputs + 1, deadline);
    }
    bool stepMs(int ms) { return step(ms / 2); }
    /// Advances robot and clock independently of the controller.
    void stepAlone(int ticks = 1) {
        for (int i = 0; i < ticks; ++i) {
            tick();
            if (everyTick) {
                everyTick();
            }
        }
    }
    /// Waits until no program is running. A program that was not ended because release() timed out first ends
    /// after 5 s without a heartbeat. Returns false if the program continues.
    bool programEnds() {
        constexpr double kTestTimeout = 6;  // [s] robot time
        for (int ticks = static_cast<int>(kTestTimeout / robot.stepTime());
             ticks > 0 && robot.truth().runtimeState != RuntimeState::Stopped; --ticks) {
            stepAlone();
        }
        return robot.truth().runtimeState == RuntimeState::Stopped;
    }
    /// Holds a jog for this time and refreshes it every 20 ms.
    bool hold(const control::Jog& jog, int ms) {
        for (int t = 0; t < ms; t += 2) {
            if (t % 20 == 0 && !jog.refresh()) {
                return false;
            }
            if (!step()) {
                return false;
            }
        }
        return true;
    }
    bool holdMove(const control::Motion& move, int atMostMs) {
        for (int t = 0; t < atMostMs; t += 2) {
            if (t % 20 == 0 && !move.refresh()) {
                return true;
            }
            if (!step()) {
                return false;
            }
        }
        return false;
    }
    /// Returns the number of control periods until standstill; -1 if the arm does not stop within this time
    /// [ms].
    int ticksToStandstill(int atMostMs) {
        for (int ticks = 0; ticks * 2 <= atMostMs; ++ticks) {
            if (isStanding()) {
                return ticks;
            }
            step();
        }
        return -1;
    }
    bool standsWithinMs(int limitMs) { return ticksToStandstill(limitMs) >= 0; }
    bool isStanding() const {
        const auto truth = robot.truth();
        return truth.tcpSpeed.linear.norm() < 0.001 && truth.qd.values.cwiseAbs().maxCoeff() < 0.001;
    }
    Pose tcp() const { return robot.truth().tcpPose; }

    CellClock clock;
    simulator::Simulator robot;
    std::unique_ptr<control::Controller> controller;
    std::function<void()> everyTick;

private:
    static simulator::SimulatorOptions robotOptions(
        const std::function<void(simulator::SimulatorOptions&)>& adjust) {
        simulator::SimulatorOptions options;
        options.anyFreePorts = true;
        options.time = simulator::Time::Virtual;
        options.poweredOn = true;
        if (adjust) {
            adjust(options);
        }
        return options;
    }
    void tick() {
        clock.advanceNs(static_cast<std::int64_t>(robot.stepTime() * 1e9 + 0.5));
        robot.step();
    }
    // Waits for the replies to everything sent before.
    void settle() {
        const Deadline deadline = Deadline::after(std::chrono::seconds(20));
        while (controller->status().inControl &&
               controller->status().answeredTime < robot.truth().timestamp && !deadline.hasExpired()) {
            robot.drainSockets();
        }
        for (int calm = 0; calm < 5; ++calm) {
            const std::uint64_t inputs = robot.inputPackages();
            if (robot.waitForInputPackages(inputs + 1, Deadline::after(std::chrono::milliseconds(10)))) {
                calm = -1;
            }
        }
    }
};

inline control::JogTarget linearJog(double x, double y, double z,
                                    control::JogFrame frame = control::JogFrame::Base) {
    control::JogTarget target;
    target.frame = frame;
    target.twist.linear = {x, y, z};
    return target;
}

inline control::JogTarget rotationJog(double x, double y, double z,
                                      control::JogFrame frame = control::JogFrame::Base) {
    control::JogTarget target;
    target.frame = frame;
    target.twist.angular = {x, y, z};
    return target;
}

inline control::JogTarget jointJog(int joint, double speed) {
    control::JogTarget target;
    target.kind = control::JogTarget::Kind::Joint;
    target.qd[joint] = speed;
    return target;
}

}  // namespace tiller::test
