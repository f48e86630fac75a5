// SPDX-License-Identifier: MIT
// Timing of a program written for ur_rtde: the regularity of its servo loop, and the time from a stream
// command to the first package in which the target of the arm moves.
#include <ur_rtde/rtde_control_interface.h>

#include <QTextStream>
#include <cmath>
#include <thread>

#include "robot/core/clock.h"
#include "robot/receive/receiver.h"
#include "robot/simulator/simulator.h"
#include "tests/benchmarks/backend/report.h"

namespace tiller::benchmark {

namespace {

using namespace std::chrono_literals;
using ControlInterface = ur_rtde::RTDEControlInterface;
using List = std::vector<double>;

constexpr double kTurn = 0.3;  // [rad/s]

double wristTargetSpeed(const receive::Receiver& receiver, receive::Sample& sample) {
    receiver.latest(sample);
    return sample.field("target_qd")[5];
}

/// Measures the time from the call to the first package with the requested target speed of the wrist.
template <class Command>
Spans reactions(const receive::Receiver& receiver, int count, Command command) {
    Spans spans(static_cast<std::size_t>(count));
    receive::Sample sample(receiver.layout());
    for (int i = 0; i < count; ++i) {
        const double wanted = i % 2 == 0 ? kTurn : -kTurn;
        const double before = wristTargetSpeed(receiver, sample);
        // Start at a varying time within the robot's period.
        std::this_thread::sleep_for(20ms + std::chrono::microseconds(137 * (i % 29)));
        const std::int64_t begin = SteadyClock::shared().nowNs();
        if (!command(wanted)) {
            break;
        }
        while (std::abs(wristTargetSpeed(receiver, sample) - before) < 1e-6 &&
               SteadyClock::shared().nowNs() - begin < kNsPerSecond) {
            std::this_thread::sleep_for(20us);
        }
        spans.add(begin, SteadyClock::shared().nowNs());
        std::this_thread::sleep_for(60ms);
    }
    return spans;
}

void add(Report& report, const QString& what, const Spans& spans) {
    const Durations all = spans.all();
    for (const double percent : {50.0, 99.0, 99.9}) {
        report.add(what + QStringLiteral(": p%1").arg(percent),
                   static_cast<double>(all.percentileNs(percent)) / 1e6, QStringLiteral("ms"));
    }
    report.add(what + QStringLiteral(": count"), static_cast<double>(all.count()), QString());
}

Spans circle(ControlInterface& face, const receive::Receiver& receiver, double seconds) {
    receive::Sample sample(receiver.layout());
    receiver.latest(sample);
    const auto pose = sample.field("actual_TCP_pose");
    const List centre(pose.begin(), pose.end());
    constexpr double kRadius = 0.05;
    const auto cycles = static_cast<std::size_t>(seconds * 500);
    Spans spans(cycles);
    std::int64_t previous = SteadyClock::shared().nowNs();
    for (std::size_t i = 0; i < cycles; ++i) {
        const auto begin = face.initPeriod();
        const double phase = 6.283185307179586 * 0.25 * static_cast<double>(i) * 0.002;
        List target = centre;
        target[0] += kRadius * (std::cos(phase) - 1);
        target[1] += kRadius * std::sin(phase);
        if (!face.servoL(target, 0, 0, 0.002, 0.1, 300)) {
            break;
        }
        face.waitPeriod(begin);
        const std::int64_t now = SteadyClock::shared().nowNs();
        spans.add(previous, now);
        previous = now;
    }
    face.servoStop();
    return spans;
}

}  // namespace

void measureUrRtde(Report& report, const Wishes& wishes) {
    report.begin(QStringLiteral("the ur_rtde interface"));
    QTextStream(stderr) << "the ur_rtde interface...\n";
    simulator::SimulatorOptions options;
    options.listenAddress = QStringLiteral("127.0.8.120");
    options.poweredOn = true;
    options.fastTransitions = true;
    simulator::Simulator robot(options);
    if (const auto started = robot.start(); !started) {
        report.cannot(QStringLiteral("the simulated controller"), started.error().toString());
        return;
    }
    receive::ReceiverOptions following;
    following.host = options.listenAddress;
    receive::Receiver receiver(following);
    if (const auto begun = receiver.start(); !begun) {
        report.cannot(QStringLiteral("the receiver"), begun.error().toString());
        return;
    }
    {
        ControlInterface face(options.listenAddress.toStdString());
        std::this_thread::sleep_for(500ms);
        add(report, QStringLiteral("%1 s servoL circle, cycles").arg(wishes.seconds),
            circle(face, receiver, wishes.seconds));
        add(report, QStringLiteral("speedJ, call to target"),
            reactions(receiver, wishes.roundTrips, [&](double v) {
                return face.speedJ({0, 0, 0, 0, 0, v}, 40.0);
            }));
        face.speedStop();
        face.stopScript();
    }
    receiver.stop();
    robot.stop();
}

}  // namespace tiller::benchmark
