// SPDX-License-Identifier: MIT
#include <ur_rtde/rtde_io_interface.h>
#include <ur_rtde/rtde_receive_interface.h>

#include <thread>

#include "common.h"

int main(int, char** argv) {
    RTDEIOInterface rtde_io(argv[1]);
    RTDEReceiveInterface rtde_receive(argv[1]);
    const auto wait = [&](std::uint8_t output, bool level) {
        while (rtde_receive.getDigitalOutState(output) != level) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    };
    rtde_io.setStandardDigitalOut(7, true);
    rtde_io.setToolDigitalOut(0, true);
    wait(7, true);
    wait(16, true);
    rtde_io.setStandardDigitalOut(7, false);
    rtde_io.setToolDigitalOut(0, false);
    wait(7, false);
    wait(16, false);
    require(rtde_io.setAnalogOutputCurrent(1, 0.25), "setAnalogOutputCurrent");
    return 0;
}
