// SPDX-License-Identifier: MIT
// Reads joint positions and TCP pose once, and then the next 500 packets.
#include <iostream>

#include "robot/receive/receiver.h"
#include "robot/receive/robot_state.h"

using namespace tiller;
using namespace std::chrono_literals;

int main(int, char** argv) {
    receive::Receiver receiver({.host = argv[1]});
    receiver.start().value();  // starts a thread, SCHED_FIFO if permitted; value() throws on errors
    const receive::Sample first = receiver.waitForData(Deadline::after(5s)).value();
    const receive::RobotState state(first);  // missing values are NaN
    std::cout << "joints [rad] " << state.q() << "\nTCP [m, rad] " << state.tcpPose() << std::endl;

    receive::Subscription stream = receiver.subscribe();
    receive::Sample sample;
    for (int packet = 0; packet < 500; ++packet) {  // every packet once, up to 500 per second
        stream.next(sample, Deadline::after(5s)).value();
        if (packet % 100 == 0) {
            const receive::RobotState now(sample);
            std::cout << now.timestamp() << " s " << now.robotMode() << ' ' << now.tcpForce() << std::endl;
        }
    }
}
