// SPDX-License-Identifier: MIT
#pragma once

// One cell of the stop contract: a motion of the native library, something that must end it, and what the arm
// does then. In virtual time: the robot is stepped, and the controller answers what it was sent before the
// next step, unless the event keeps it from doing so.

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

/// Stands still until told to go on. Frozen, nobody but the test gets the time: what asks for it stops there,
/// as a process does that a debugger or SIGSTOP holds.
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
    /// What is sent at once where time goes on, and otherwise with the next data, is sent at once.
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

/// A way of moving: begun once, held for as long as it lasts, and never begun again.
struct ContractMotion {
    const char* name;
    /// Builtin it cannot do without, if that may be missing.
    const char* needs;
    bool byHand;  ///< a hand pushes the arm
    bool isLong;  ///< it begins with a program that has to be sent first
    double fast;  ///< TCP speed it reaches [m/s], at a slider of 100 %
    std::function<Error(ContractCell&)> begin;
    std::function<void(ContractCell&)> hold;
    bool yields = false;  ///< force mode or freedrive is on
    SoftwareVersion
        since{};  ///< the first software that has it, where that is newer than the simulator's own
};

const std::vector<ContractMotion>& contractMotions();

struct ContractEvent {
    const char* name;
    double limitMs;  ///< to standstill
    std::function<void(ContractCell&)> happen;
    /// What may be done after it, in order, each with some time: none of it may move the arm.
    std::vector<std::function<void(ContractCell&)>> after;
    bool robotBrakes = false;  ///< how long that takes is the robot's own affair
    bool losesBoth = false;    ///< the process dies and the program is paused
    double watched = 0.4;      ///< from it to what is done after it [s]
};

const std::vector<ContractEvent>& contractEvents();
/// The robot leaves remote control, and nobody is there any more who might do something about it.
const ContractEvent& lostInLocal();
/// Pauses that the process does not live to see the end of, and that are over soon.
const std::vector<ContractEvent>& shortPauses();

struct ContractOutcome {
    bool applies = true;  ///< false: the controller has no such motion, and the library said so
    double standstillMs = 0;
    double driftMm = 0;    ///< from the event to standstill
    double resumedMm = 0;  ///< furthest from there afterwards
    QString problem;       ///< empty: within the contract
};

class ContractCell {
public:
    ContractCell(const simulator::Assumptions& assumptions, double slider,
                 const SoftwareVersion& software = simulator::SimulatorOptions().software);
    ~ContractCell();

    ContractOutcome run(const ContractMotion& motion, const ContractEvent& event);

    // for motions and events
    void step();
    void stepMs(int ms) {
        for (double t = 0; t < ms; t += stepTimeMs()) {
            step();
        }
    }
    /// Runs something that waits for the robot while time goes on.
    template <class Call>
    auto during(Call call, int patienceMs = 20'000) {
        std::optional<decltype(call())> result;
        std::atomic<bool> done{false};
        std::thread caller([&] {
            result.emplace(call());
            done = true;
        });
        while (!done) {
            step(patienceMs);
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
    // streams, for those who hold them
    std::function<void()> send;
    bool reachable = true;  ///< packages get from one to the other
    bool holding = true;
    QString fault;  ///< of the event itself

private:
    double stepTimeMs() const { return 1000 * robot.stepTime(); }
    void step(int patienceMs);
    bool takeControl(QString& why);

    double slider_;
    const ContractMotion* held_ = nullptr;
    std::unique_ptr<script::ScriptClient> primary_;
};

}  // namespace tiller::test
