// SPDX-License-Identifier: MIT
// A program without a QCoreApplication. First it controls a robot in another process from a thread that then
// ends. Afterwards it simulates a robot. With the argument "threads", it also simulates the robot in such a
// thread. It prints "done" if both worked, without Qt warnings (except with "threads", which Qt warns about)
// and without errors of memory checkers.
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <iostream>
#include <string_view>
#include <thread>

#include "robot/control/controller.h"
#include "robot/core/deadline.h"
#include "robot/simulator/simulator.h"

namespace {

using namespace std::chrono_literals;
using tiller::Deadline;

bool control(const QString& host) {
    tiller::control::ControllerOptions options;
    options.host = host;
    options.priority = 0;
    tiller::control::Controller controller(options);
    const auto taken = controller.takeControl(Deadline::after(60s));
    if (!taken.ok()) {
        std::cerr << taken.error().message() << "\n";
    }
    return taken.ok();
}

tiller::simulator::SimulatorOptions poweredOn(const QString& host) {
    tiller::simulator::SimulatorOptions options;
    options.listenAddress = host;
    options.poweredOn = true;
    options.fastTransitions = true;
    return options;
}

bool simulate(const QString& host) {
    tiller::simulator::Simulator robot(poweredOn(host));
    const auto started = robot.start();
    if (!started.ok()) {
        std::cerr << started.error().message() << "\n";
        return false;
    }
    return control(host);
}

/// Simulates a robot until the parent process terminates it. Reports when it is ready.
[[noreturn]] void beRobot(const QString& host, int ready) {
    tiller::simulator::Simulator robot(poweredOn(host));
    const char word = robot.start().ok() ? 'y' : 'n';
    (void)!::write(ready, &word, 1);
    for (;;) {
        ::pause();
    }
}

}  // namespace

int main(int argc, char** argv) {
    const bool inThreads = argc > 1 && std::string_view(argv[1]) == "threads";
    // Both ctest entries of this program may run at the same time.
    const QString own = QStringLiteral("127.77.%1.1").arg(inThreads ? 1 : 0);
    const QString other = QStringLiteral("127.77.%1.2").arg(inThreads ? 1 : 0);
    int ready[2];
    if (::pipe(ready) != 0) {
        return 1;
    }
    const pid_t robot = ::fork();
    if (robot == 0) {
        beRobot(other, ready[1]);
    }
    char word = 'n';
    (void)!::read(ready[0], &word, 1);
    bool good = word == 'y';
    std::thread([&] { good = good && control(other); }).join();
    const auto second = [&] { good = good && simulate(own); };
    if (inThreads) {
        std::thread(second).join();
    } else {
        second();
    }
    ::kill(robot, SIGKILL);
    ::waitpid(robot, nullptr, 0);
    std::cout << (good ? "done" : "failed") << std::endl;
    return good ? 0 : 1;
}
