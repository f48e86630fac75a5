// SPDX-License-Identifier: MIT
#include <ur_rtde/rtde_receive_interface.h>

#include <fstream>
#include <thread>

#include "common.h"

int main(int, char** argv) {
    double frequency = 500.0;
    double dt = 1.0 / frequency;
    RTDEReceiveInterface rtde_receive(argv[1], frequency);
    const std::string file = argv[2];
    require(rtde_receive.startFileRecording(file), "startFileRecording");
    for (int i = 0; i < 50; ++i) {
        steady_clock::time_point t_start = steady_clock::now();
        rtde_receive.receiveCallback();
        std::this_thread::sleep_until(t_start + duration_cast<steady_clock::duration>(duration<double>(dt)));
    }
    require(rtde_receive.stopFileRecording(), "stopFileRecording");
    std::ifstream csv(file);
    std::string header;
    std::getline(csv, header);
    require(header.find("actual_TCP_pose_5") != std::string::npos, "the columns");
    return 0;
}
