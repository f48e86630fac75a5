// SPDX-License-Identifier: MIT
// Waypoints with blends, as rows of numbers and as a path with mixed moves.
#include <ur_rtde/rtde_control_interface.h>
#include <ur_rtde/rtde_receive_interface.h>

#include "common.h"

int main(int, char** argv) {
    RTDEControlInterface rtde_control(argv[1]);
    RTDEReceiveInterface rtde_receive(argv[1]);
    require(rtde_control.moveJ(kHome), "moveJ");
    double velocity = 0.5;
    double acceleration = 0.5;
    std::vector<double> p1 = rtde_receive.getActualTCPPose();
    std::vector<double> p2 = p1;
    std::vector<double> p3 = p1;
    p2[2] += 0.05;
    p3[0] += 0.05;
    std::vector<std::vector<double>> path;
    for (auto* p : {&p1, &p2, &p3}) {
        std::vector<double> row = *p;
        row.push_back(velocity);
        row.push_back(acceleration);
        row.push_back(p == &p2 ? 0.02 : 0.0);
        path.push_back(row);
    }
    require(rtde_control.moveL(path), "moveL path");
    require(isNear([&] { return rtde_receive.getActualTCPPose(); }, p3, 0.005), "the end of the path");

    ur_rtde::Path mixed;
    std::vector<double> home = kHome;
    home.insert(home.end(), {velocity, acceleration, 0.0});
    mixed.addEntry({PathEntry::MoveJ, PathEntry::PositionJoints, home});
    std::vector<double> last = path[1];
    last.back() = 0.0;  // there is no following move to blend into
    mixed.addEntry({PathEntry::MoveL, PathEntry::PositionTcpPose, last});
    rtde_control.movePath(mixed, true);
    while (rtde_control.getAsyncOperationProgress() >= 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    require(isNear([&] { return rtde_receive.getActualTCPPose(); }, p2, 0.005), "the end of the mixed path");
    rtde_control.stopScript();
    return 0;
}
