// SPDX-License-Identifier: MIT
#pragma once

// One case of the stop contract: a motion of the native library, an event that must end it, and the reaction
// of the arm. The test runs in virtual time. The robot is stepped, and the controller replies before the next
// step unless the event prevents it.

#include <QRandomGenerator>
#include <QTest>
#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "robot/control/compliance.h"
#include "robot/control/controller.h"
#include "robot/control/motions.h"
#include "robot/control/programs.h"
#include "robot/core/clock.h"
#include "robot/script/script_client.h"
#include "robot/simulator/simulator.h"

namespace tiller::test {

/// A clock that is advanced manually. While it is frozen, all threads except that of the test block when they
/// read the time, as in a process stopped by a debugger or SIGSTOP.
class FreezingClock final : public Clock {
public:
    std::int64_t nowNs() const override {
        if (std::this_thread::get_id() != owner_) {
            std::unique_lock lock(mutex_);
            thawed_.wait(lock, [this] { return !frozen_; });
        }
        return clock_.nowNs();
    }
    bool runsByItself() const override { return pretending_; }
    void waitUntil(std::int64_t, std::int64_t) const override {}
    void advanceNs(std::int64_t ns) { clock_.advanceNs(ns); }
    /// Data that are otherwise sent with the next package are sent immediately.
    void pretendToRun(bool pretending) { pretending_ = pretending; }
    void freeze(bool frozen) {
        {
            const std::lock_guard lock(mutex_);
            frozen_ = frozen;
        }
        thawed_.notify_all();
    }
    bool isFrozen() const {
        const std::lock_guard lock(mutex_);
        return frozen_;
    }

private:
    VirtualClock clock_;
    const std::thread::id owner_ = std::this_thread::get_id();
    mutable std::mutex mutex_;
    mutable std::condition_variable thawed_;
    bool frozen_ = false;
    std::atomic<bool> pretending_ = false;
};

class ContractCell;

/// A type of motion. It is started once, held for its duration, and never restarted.
struct ContractMotion {
    const char* name;
    /// built-in function that the motion needs and that a controller may not have
    const char* needs;
    bool byOperator;  ///< an external force moves the arm
    bool isLong;      ///< true if the motion starts by sending a program
    double fast;      ///< resulting TCP speed [m/s] with the speed slider at 100 %
    std::function<Error(ContractCell&)> begin;
    std::function<void(ContractCell&)> hold;
    bool yields = false;  ///< force mode or freedrive is active
    SoftwareVersion
        since{};  ///< first software version with this motion, if newer than the default of the simulator
};

const std::vector<ContractMotion>& contractMotions();

struct ContractEvent {
    const char* name;
    double limitMs;  ///< maximum time to standstill
    std::function<void(ContractCell&)> happen;
    /// Actions after the event, in order, with a pause after each. None of them may move the arm.
    std::vector<std::function<void(ContractCell&)>> after;
    bool robotBrakes = false;  ///< true if only the robot determines the time to standstill
    bool losesBoth = false;    ///< true if the process is killed while the program is paused
    double watched = 0.4;      ///< time between the event and the following actions [s]
};

const std::vector<ContractEvent>& contractEvents();
/// The robot leaves remote control, so that no client can stop it.
const ContractEvent& lostInLocal();
/// Short pauses during which the process ends.
const std::vector<ContractEvent>& shortPauses();

struct ContractOutcome {
    /// False if the controller does not have this motion, and the library reported that.
    bool applies = true;
    double standstillMs = 0;
    double driftMm = 0;    ///< distance from the event to standstill
    double resumedMm = 0;  ///< maximum distance after standstill
    QString problem;       ///< empty if the result complies with the contract
};

class ContractCell {
public:
    ContractCell(const simulator::BehaviourOptions& assumptions, double slider,
                 const SoftwareVersion& software = simulator::SimulatorOptions().software);
    ~ContractCell();

    ContractOutcome run(const ContractMotion& motion, const ContractEvent& event);

    // used by motions and events
    void step();
    void stepMs(int ms) {
        for (double t = 0; t < ms; t += stepTimeMs()) {
            step();
        }
    }
    /// Runs a function that waits for the robot while time advances.
    template <class Call>
    auto during(Call call, int testTimeoutMs = 20'000) {
        std::optional<decltype(call())> result;
        std::atomic<bool> done{false};
        std::thread caller([&] {
            result.emplace(call());
            done = true;
        });
        while (!done) {
            step(testTimeoutMs);
        }
        caller.join();
        return *result;
    }
    void say(const char* line) {
        (void)primary_->send(QString::fromLatin1(line), Deadline::after(std::chrono::seconds(20)));
    }
    void inject(const char* words) {
        if (const auto done = robot.inject(QString::fromLatin1(words)); !done) {
            qFatal("%s", words);
        }
    }
    bool isStanding() const {
        const auto truth = robot.truth();
        return truth.tcpSpeed.linear.norm() < 0.001 && truth.qd.values.cwiseAbs().maxCoeff() < 0.001;
    }

    FreezingClock clock;
    simulator::Simulator robot;
    std::unique_ptr<control::Controller> controller;
    control::Motion motion;
    control::Jog jog;
    // used by streams; called by the thread that holds the stream
    std::function<void()> send;
    bool reachable = true;  ///< true while packages are transmitted
    bool holding = true;
    QString fault;  ///< error of the event itself

private:
    double stepTimeMs() const { return 1000 * robot.stepTime(); }
    void step(int testTimeoutMs);
    bool takeControl(QString& why);

    double slider_;
    const ContractMotion* held_ = nullptr;
    std::unique_ptr<script::ScriptClient> primary_;
};

}  // namespace tiller::test
