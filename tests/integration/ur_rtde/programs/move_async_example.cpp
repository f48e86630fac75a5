// SPDX-License-Identifier: MIT
// Starts two asynchronous moves and stops each of them before it reaches its target.
#include <ur_rtde/rtde_control_interface.h>
#include <ur_rtde/rtde_receive_interface.h>

#include "common.h"

int main(int, char** argv) {
    RTDEControlInterface rtde_control(argv[1]);
    RTDEReceiveInterface rtde_receive(argv[1]);
    std::vector<double> init_q = rtde_receive.getActualQ();
    std::vector<double> target = rtde_receive.getActualTCPPose();
    target[2] += 0.20;
    rtde_control.moveL(target, 0.02, 0.5, true);
    while (rtde_control.getAsyncOperationProgress() < 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    rtde_control.stopL(0.5);
    require(rtde_receive.getActualTCPPose()[2] < target[2] - 0.01, "stopped on the way");
    std::vector<double> new_q = init_q;
    new_q[0] += 0.2;
    rtde_control.moveJ(new_q, 0.05, 0.5, true);
    while (rtde_control.getAsyncOperationProgress() < 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    rtde_control.stopJ(0.5);
    require(rtde_control.moveJ(init_q), "back home");
    rtde_control.stopScript();
    return 0;
}
