// SPDX-License-Identifier: MIT
// Measures how often a gap in the data or in the heartbeat ends a move to a target, with and without
// real-time priorities, and with the default and a longer heartbeat timeout. Also prints the longest gap in
// the data and the measured delay of each move that ended early.
//
//     bounded_moves [seconds per row, 30 by default] [busy threads, 0 by default]
//
// The simulated controller has a higher priority than all other threads, so that it is never the cause of a
// gap.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "robot/api/robot.h"
#include "robot/simulator/simulator.h"

using namespace tiller;
using namespace std::chrono_literals;

namespace {

struct Row {
    int priority;
    std::chrono::milliseconds heartbeatTimeout;
};

/// Moves the last joint back and forth. Each move takes about a second.
void measure(const QString& host, const Row& row, double seconds) {
    RobotOptions options;
    options.control.priority = row.priority;
    options.control.dataTimeout = row.heartbeatTimeout;
    Robot robot(host, options);
    robot.connect(Deadline::after(20s)).value();
    int moves = 0;
    std::vector<std::string> ended;
    double longestGapMs = 0;
    std::int64_t previousNs = 0;
    receive::Subscription packets = robot.subscribe();
    receive::Sample packet = robot.latest();
    const receive::Sample first = robot.latest();
    JointPositions target = receive::RobotState(first).q();
    const Deadline end = Deadline::after(std::chrono::duration<double>(seconds));
    while (!end.hasExpired()) {
        if (!robot.status().inControl) {
            robot.takeControl(Deadline::after(20s)).value();
        }
        target[5] += moves % 2 == 0 ? 0.5 : -0.5;
        const auto move =
            robot.motions().moveJ(target, {.speed = 1.0, .heartbeatTimeout = row.heartbeatTimeout});
        if (!move) {  // refused during a gap that has ended the previous move
            std::this_thread::sleep_for(10ms);
            continue;
        }
        const Result<void> reached = move->wait(Deadline::after(30s));
        ++moves;
        if (!reached) {
            ended.push_back(reached.error().message());
        }
        while (packets.next(packet)) {
            if (previousNs != 0) {
                longestGapMs =
                    std::max(longestGapMs, static_cast<double>(packet.hostTimeNs - previousNs) / 1e6);
            }
            previousNs = packet.hostTimeNs;
        }
    }
    const control::ControllerStatus status = robot.status();
    std::printf("%8d  %7s  %10lld  %5d  %11.1f  %11zu\n", row.priority, status.priorityGranted ? "yes" : "no",
                static_cast<long long>(row.heartbeatTimeout.count()), moves, longestGapMs, ended.size());
    for (const std::string& why : ended) {
        std::printf("          %s\n", why.c_str());
    }
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const double seconds = argc > 1 ? std::atof(argv[1]) : 30;
    const int busy = argc > 2 ? std::atoi(argv[2]) : 0;
    simulator::SimulatorOptions options;
    options.listenAddress = QStringLiteral("127.0.8.110");
    options.poweredOn = true;
    options.fastTransitions = true;
    options.priority = 95;
    simulator::Simulator robot(options);
    robot.start().value();
    std::atomic<bool> ends{false};
    std::vector<std::thread> load;
    for (int i = 0; i < busy; ++i) {
        load.emplace_back([&ends] {
            while (!ends.load(std::memory_order_relaxed)) {
            }
        });
    }
    std::printf("simulated controller: priority %s; %d busy threads\n",
                robot.timing().priorityGranted ? "granted" : "refused", busy);
    std::printf("%8s  %7s  %10s  %5s  %11s  %11s\n", "priority", "granted", "limit [ms]", "moves",
                "longest gap", "ended early");
    for (const Row& row : {Row{0, 100ms}, Row{85, 100ms}, Row{0, 300ms}, Row{85, 300ms}}) {
        measure(options.listenAddress, row, seconds);
    }
    ends = true;
    for (std::thread& thread : load) {
        thread.join();
    }
}
