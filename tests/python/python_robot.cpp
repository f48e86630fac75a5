// SPDX-License-Identifier: MIT
// A simulated robot for the Python tests. Arguments: "real" (in real time), "torque" (software with torque
// commands), "low" (starts at the start position of the stop contract programs). Prints its address on the
// first line, executes the commands on its standard input (freeze, thaw, hand, push, free, cut, join, still,
// speed, turning, watch), and exits when the input ends.
// "still" waits until the arm is at standstill and returns the duration of its motion after the last received
// packet, in milliseconds of robot time. "speed" returns the TCP speed [m/s], "turning" the speed of the
// fastest joint [rad/s].
// "watch" observes the arm for one second and returns how long [ms] and how far [rad] it moved after the last
// received packet, how long it moved after the command [ms], and whether it is still moving.
#include <QCoreApplication>
#include <algorithm>
#include <iostream>
#include <string>

#include "tests/integration/ur_rtde/ur_rtde_cell.h"

namespace {

double untilStill(tiller::test::UrRtdeCell& cell) {
    double reported = cell.robot.truth().timestamp;
    std::uint64_t packages = cell.robot.inputPackages();
    double moved = reported;
    const auto stands = [&](const tiller::simulator::SimulatedState& truth) {
        if (cell.robot.inputPackages() != packages) {
            packages = cell.robot.inputPackages();
            reported = truth.timestamp;
        }
        const bool still = truth.qd.values.cwiseAbs().maxCoeff() < 2e-3;
        moved = still ? moved : truth.timestamp;
        return still;
    };
    constexpr double kNever = 1e6;
    return cell.until(stands) ? std::max(moved - reported, 0.0) * 1000 : kNever;
}

std::string watch(tiller::test::UrRtdeCell& cell) {
    constexpr double kSeconds = 1.0;
    tiller::simulator::SimulatedState heard = cell.robot.truth();
    const double begin = heard.timestamp;
    const double end = begin + kSeconds;
    std::uint64_t packages = cell.robot.inputPackages();
    double moved = heard.timestamp;
    bool moves = false;
    tiller::JointPositions last = heard.q;
    cell.until([&](const tiller::simulator::SimulatedState& truth) {
        if (cell.robot.inputPackages() != packages) {
            packages = cell.robot.inputPackages();
            heard = truth;
        }
        moves = truth.qd.values.cwiseAbs().maxCoeff() >= 2e-3;
        moved = moves ? truth.timestamp : moved;
        last = truth.q;
        return truth.timestamp >= end;
    });
    const double angle = (last.values - heard.q.values).cwiseAbs().maxCoeff();
    return std::to_string(std::max(moved - heard.timestamp, 0.0) * 1000) + ' ' + std::to_string(angle) + ' ' +
           std::to_string((moved - begin) * 1000) + (moves ? " moves" : " still");
}

}  // namespace

int main(int argc, char** argv) {
    QCoreApplication app(argc, argv);
    const QStringList arguments = app.arguments();
    tiller::test::UrRtdeCell cell([&arguments](tiller::simulator::SimulatorOptions& options) {
        const bool real = arguments.contains(QLatin1String("real"));
        options.time = real ? tiller::simulator::Time::Real : tiller::simulator::Time::Virtual;
        if (arguments.contains(QLatin1String("torque"))) {
            options.software = {5, 25, 1, 0};
        }
        if (arguments.contains(QLatin1String("low"))) {
            options.startJoints = tiller::JointPositions(-1.57, -1.2, -2.3, -1.2, 1.57, 0);
        }
    });
    std::cout << cell.host() << std::endl;
    for (std::string word; std::getline(std::cin, word);) {
        if (word == "freeze" || word == "thaw") {
            cell.freeze(word == "freeze");
        } else if (word == "hand" || word == "push" || word == "free") {
            constexpr double kFirm = 150;  // [N]
            constexpr double kGentle = 12;
            tiller::Vector6 wrench = tiller::Vector6::Zero();
            wrench[2] = word == "hand" ? kFirm : word == "push" ? kGentle : 0;
            cell.robot.pressHand(tiller::Wrench::fromVector(wrench));
        }
        if (word == "cut" || word == "join") {
            (void)cell.robot.inject(word == "cut" ? "link lost" : "link back");
        }
        if (word == "speed") {
            std::cout << cell.robot.truth().tcpSpeed.linear.norm() << std::endl;
            continue;
        }
        if (word == "turning") {
            std::cout << cell.robot.truth().qd.values.cwiseAbs().maxCoeff() << std::endl;
            continue;
        }
        if (word == "watch") {
            std::cout << watch(cell) << std::endl;
            continue;
        }
        if (word == "still") {
            std::cout << untilStill(cell) << std::endl;
            continue;
        }
        std::cout << "ok" << std::endl;
    }
    return 0;
}
