// SPDX-License-Identifier: MIT
// Moves the arm through the C interface until the process ends. A line on the standard input selects how it
// ends (see endProcess()). "object" closes the robot object, and the process continues to run:
//     c_mover <host> <motion>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <string>
#include <thread>

#include "robot/c/tiller_c.h"
#include "tests/support/process_end.h"

namespace {

bool well(int status) {
    if (status != TILLER_OK) {
        std::fprintf(stderr, "%s\n", tiller_last_error());
    }
    return status == TILLER_OK;
}

bool begin(tiller_robot* robot, const std::string& motion) {
    double numbers[6];
    if (motion == "move_j") {
        const bool known = well(tiller_read(robot, "actual_q", numbers, 6, nullptr));
        numbers[0] += 1.5;
        return known && well(tiller_move_j(robot, numbers, 0.4, 0));
    }
    const bool known = well(tiller_read(robot, "actual_TCP_pose", numbers, 6, nullptr));
    numbers[2] -= 0.3;
    return known && well(tiller_move_l(robot, numbers, 0.1, 0.5));
}

}  // namespace

int main(int argc, char** argv) {
    constexpr double kTimeout = 30;  // [s]
    tiller_robot* robot = nullptr;
    if (argc != 3 || !well(tiller_connect(argv[1], kTimeout, &robot)) ||
        !well(tiller_take_control(robot, kTimeout)) || !begin(robot, argv[2])) {
        return 1;
    }
    for (std::string line; std::getline(std::cin, line);) {
        if (line == "object") {
            tiller_close(robot);
        }
        tiller::test::endProcess(line);
    }
    std::this_thread::sleep_for(std::chrono::hours(1));
}
