// SPDX-License-Identifier: MIT
// Jogs the tool upwards for one second by refreshing the jog.
#include <iostream>
#include <thread>

#include "robot/control/motions.h"

using namespace tiller;
using namespace std::chrono_literals;

int main(int, char** argv) {
    control::Controller controller({.host = argv[1]});
    controller.takeControl(Deadline::after(5s)).value();
    const double before = controller.status().tcpPose[2];

    control::JogTarget up;
    up.twist.linear.z() = 0.05;  // [m/s] in the base frame
    const control::Jog jog = control::Motions(controller).startJog(up).value();
    for (int i = 0; i < 50; ++i) {
        std::this_thread::sleep_for(20ms);
        if (!jog.refresh()) {  // at least every 100 ms, otherwise the arm stops
            std::cerr << "the jog ended: " << jog.state().cause << std::endl;
            return EXIT_FAILURE;
        }
    }
    jog.cancel();
    std::cout << "rose " << 1000 * (controller.status().tcpPose[2] - before) << " mm" << std::endl;
}
