// SPDX-License-Identifier: MIT
#include <ur_rtde/robotiq_gripper.h>

#include "common.h"

int main(int, char** argv) {
    RobotiqGripper gripper(argv[1], 63352, true);
    gripper.connect();
    gripper.activate();
    gripper.setUnit(RobotiqGripper::POSITION, RobotiqGripper::UNIT_DEVICE);
    std::cout << "open " << gripper.getOpenPosition() << " closed " << gripper.getClosedPosition()
              << std::endl;
    gripper.setUnit(RobotiqGripper::POSITION, RobotiqGripper::UNIT_NORMALIZED);
    require(gripper.move(1, 1, 0, RobotiqGripper::WAIT_FINISHED) != RobotiqGripper::MOVING, "move");
    require(gripper.close(0.02F, 0, RobotiqGripper::START_MOVE) == RobotiqGripper::MOVING, "close");
    while (gripper.objectDetectionStatus() == RobotiqGripper::MOVING) {
    }
    require(gripper.isClosed() || gripper.getCurrentPosition() < 0.2F, "closed");
    require(gripper.waitForMotionComplete() != RobotiqGripper::MOVING, "waitForMotionComplete");
    gripper.open(1.0F, 0.0F, RobotiqGripper::WAIT_FINISHED);
    gripper.disconnect();
    return 0;
}
