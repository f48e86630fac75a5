// SPDX-License-Identifier: MIT
// A simulated robot for the Python tests. Says its address on the first line, obeys the words that come in on
// standard input (freeze, thaw, hand, free), and ends with it.
#include <QCoreApplication>
#include <iostream>
#include <string>

#include "tests/integration/ur_rtde/face_cell.h"

int main(int argc, char** argv) {
    QCoreApplication app(argc, argv);
    tiller::test::FaceCell cell;
    std::cout << cell.host() << std::endl;
    for (std::string word; std::getline(std::cin, word);) {
        if (word == "freeze" || word == "thaw") {
            cell.freeze(word == "freeze");
        } else if (word == "hand" || word == "free") {
            tiller::Vector6 wrench = tiller::Vector6::Zero();
            wrench[2] = word == "hand" ? 150 : 0;
            cell.robot.pressHand(tiller::Wrench::fromVector(wrench));
        }
        std::cout << "ok" << std::endl;
    }
    return 0;
}
