// SPDX-License-Identifier: MIT
#pragma once

// A simulated robot for programs that use the ur_rtde interface. Its virtual time advances only as fast as
// the client replies, so that a slow computer slows the robot down and the client is never late.

#include <QCoreApplication>
#include <QString>
#include <QTest>
#include <atomic>
#include <functional>
#include <thread>

#include "robot/simulator/simulator.h"

namespace tiller::test {

inline QString ownAddress(int number = 1) {
    const auto pid = static_cast<unsigned>(QCoreApplication::applicationPid());
    return QStringLiteral("127.%1.%2.%3").arg(10 + pid % 200).arg((pid / 200) % 250).arg(number);
}

class UrRtdeCell {
public:
    explicit UrRtdeCell(const std::function<void(simulator::SimulatorOptions&)>& adjust = {})
        : robot(optionsOf(adjust)) {
        if (const auto started = robot.start(); !started) {
            qFatal("%s", qPrintable(started.error().toString()));
        }
        pump_ = std::thread([this] { pump(); });
    }
    ~UrRtdeCell() {
        quit_.cancel();
        pump_.join();
        robot.stop();
    }

    std::string host() const { return robot.listenAddress().toStdString(); }
    /// Stops time, as in a controller that hangs. Connections remain open.
    void freeze(bool frozen) { frozen_ = frozen; }
    /// Waits for the condition in real time. Returns false after 30 s.
    bool until(const std::function<bool(const simulator::SimulatedState&)>& condition) {
        for (int i = 0; i < 30'000; ++i) {
            if (condition(robot.truth())) {
                return true;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return false;
    }
    /// Advances robot time, without waiting for clients that do not reply.
    bool pass(double seconds) {
        const double end = robot.truth().timestamp + seconds;
        return hurried([&] {
            return until([end](const simulator::SimulatedState& truth) { return truth.timestamp >= end; });
        });
    }
    /// Waits for a call that takes robot time. In the meantime, robot time advances without waiting for
    /// clients that do not reply.
    bool hurried(const std::function<bool()>& call) {
        hurry_ = true;
        const bool done = call();
        hurry_ = false;
        return done;
    }

    simulator::Simulator robot;

private:
    static simulator::SimulatorOptions optionsOf(
        const std::function<void(simulator::SimulatorOptions&)>& adjust) {
        simulator::SimulatorOptions options;
        options.listenAddress = ownAddress();
        options.time = simulator::Time::Virtual;
        options.poweredOn = true;
        options.fastTransitions = true;
        if (adjust) {
            adjust(options);
        }
        return options;
    }

    // After each packet, waits up to 1 s for a client that replied to the previous packet, like the control
    // interface. For other clients, waits 1 ms, or not at all in hurried().
    void pump() {
        bool answered = false;
        while (!quit_.isCancelled()) {
            if (frozen_) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
                continue;
            }
            const std::uint64_t inputs = robot.inputPackages();
            const std::uint64_t outputs = robot.outputPackages();
            robot.step();
            if (robot.truth().runtimeState == RuntimeState::Paused) {
                // The client may stop the program over another connection, which takes real time.
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
            }
            const bool asked = robot.outputPackages() != outputs;
            const auto testTimeout = std::chrono::milliseconds(answered && asked ? 1000 : hurry_ ? 0 : 1);
            const bool came = robot.waitForInputPackages(inputs + 1, Deadline::after(testTimeout, quit_));
            answered = asked ? came : answered;
        }
    }

    CancelToken quit_;
    std::atomic<bool> frozen_{false};
    std::atomic<bool> hurry_{false};
    std::thread pump_;
};

}  // namespace tiller::test
