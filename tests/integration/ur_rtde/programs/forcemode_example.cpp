// SPDX-License-Identifier: MIT
// Presses down, then up.
#include <ur_rtde/rtde_control_interface.h>

#include "common.h"

int main(int, char** argv) {
    RTDEControlInterface rtde_control(argv[1]);
    std::vector<double> task_frame = {0, 0, 0, 0, 0, 0};
    std::vector<int> selection_vector = {0, 0, 1, 0, 0, 0};
    std::vector<double> wrench_down = {0, 0, -10, 0, 0, 0};
    std::vector<double> wrench_up = {0, 0, 10, 0, 0, 0};
    int force_type = 2;
    std::vector<double> limits = {2, 2, 1.5, 1, 1, 1};
    require(rtde_control.moveJ(kHome), "moveJ");
    rtde_control.zeroFtSensor();
    rtde_control.forceModeSetDamping(0.5);
    for (unsigned int i = 0; i < 200; i++) {
        steady_clock::time_point t_start = rtde_control.initPeriod();
        const bool up = i > 100;
        require(rtde_control.forceMode(task_frame, selection_vector, up ? wrench_up : wrench_down, force_type,
                                       limits),
                "forceMode");
        rtde_control.waitPeriod(t_start);
    }
    require(rtde_control.forceModeStop(), "forceModeStop");
    rtde_control.stopScript();
    return 0;
}
