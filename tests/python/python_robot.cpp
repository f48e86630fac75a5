// SPDX-License-Identifier: MIT
// A simulated robot for the Python tests, with "real" as its argument in real time. Says its address on the
// first line, obeys the words that come in on standard input (freeze, thaw, hand, free, cut, join, still),
// and ends with it. "still" answers when the arm stands: with how long it was seen moving after it was last
// told anything, in milliseconds of the robot's time.
#include <QCoreApplication>
#include <algorithm>
#include <iostream>
#include <string>

#include "tests/integration/ur_rtde/face_cell.h"

namespace {

double untilStill(tiller::test::FaceCell& cell) {
    double told = cell.robot.truth().timestamp;
    std::uint64_t packages = cell.robot.inputPackages();
    double moved = told;
    const auto stands = [&](const tiller::simulator::Truth& truth) {
        if (cell.robot.inputPackages() != packages) {
            packages = cell.robot.inputPackages();
            told = truth.timestamp;
        }
        const bool still = truth.qd.values.cwiseAbs().maxCoeff() < 2e-3;
        moved = still ? moved : truth.timestamp;
        return still;
    };
    constexpr double kNever = 1e6;
    return cell.until(stands) ? std::max(moved - told, 0.0) * 1000 : kNever;
}

}  // namespace

int main(int argc, char** argv) {
    QCoreApplication app(argc, argv);
    const bool real = argc > 1 && std::string(argv[1]) == "real";
    tiller::test::FaceCell cell([real](tiller::simulator::SimulatorOptions& options) {
        options.time = real ? tiller::simulator::Time::Real : tiller::simulator::Time::Virtual;
    });
    std::cout << cell.host() << std::endl;
    for (std::string word; std::getline(std::cin, word);) {
        if (word == "freeze" || word == "thaw") {
            cell.freeze(word == "freeze");
        } else if (word == "hand" || word == "free") {
            tiller::Vector6 wrench = tiller::Vector6::Zero();
            wrench[2] = word == "hand" ? 150 : 0;
            cell.robot.pressHand(tiller::Wrench::fromVector(wrench));
        }
        if (word == "cut" || word == "join") {
            (void)cell.robot.inject(word == "cut" ? "link lost" : "link back");
        }
        if (word == "still") {
            std::cout << untilStill(cell) << std::endl;
            continue;
        }
        std::cout << "ok" << std::endl;
    }
    return 0;
}
