// SPDX-License-Identifier: MIT
// A robot in this process. It is moved through the ur_rtde interface and read through the backend's API.
#include <ur_rtde/rtde_control_interface.h>

#include <unistd.h>
#include <QCoreApplication>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <thread>

#include "robot/receive/receiver.h"
#include "robot/receive/robot_state.h"
#include "robot/simulator/simulator.h"

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);  // the sockets of the robot need an application object
    tiller::simulator::SimulatorOptions options;
    options.listenAddress = QStringLiteral("127.%1.%2.1").arg(10 + getpid() % 200).arg(getpid() / 200 % 250);
    options.poweredOn = true;
    options.fastTransitions = true;
    tiller::simulator::Simulator robot(options);
    if (const auto started = robot.start(); !started) {
        std::cerr << started.error().toString().toStdString() << std::endl;
        return EXIT_FAILURE;
    }
    ur_rtde::RTDEControlInterface control(options.listenAddress.toStdString());
    const auto start = tiller::simulator::kHomeJoints.array();
    std::vector<double> target(start.begin(), start.end());
    target[5] += 0.2;
    if (!control.moveJ(target)) {
        std::cerr << "moveJ" << std::endl;
        return EXIT_FAILURE;
    }
    tiller::receive::ReceiverOptions receiving;
    receiving.host = options.listenAddress;
    tiller::receive::Receiver receiver(receiving);
    if (const auto following = receiver.start(); !following) {
        std::cerr << following.error() << std::endl;
        return EXIT_FAILURE;
    }
    const auto sample = receiver.waitForData(tiller::Deadline::after(std::chrono::seconds(30)));
    if (!sample) {
        std::cerr << sample.error() << std::endl;
        return EXIT_FAILURE;
    }
    const double reached = tiller::receive::RobotState(*sample).q()[5];
    receiver.stop();
    control.disconnect();
    robot.stop();
    std::cout << "moved to " << reached << std::endl;
    return std::abs(reached - target[5]) < 1e-3 ? EXIT_SUCCESS : EXIT_FAILURE;
}
