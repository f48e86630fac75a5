# SPDX-License-Identifier: MIT
"""Shows the problems of a robot, and recovers it with the consent of a person."""
import sys

import tiller

print(tiller.examine(sys.argv[1]))
with tiller.Robot(sys.argv[1]) as robot:
    print(robot.state.robot_mode, robot.state.safety_mode)
    if robot.state.safety_mode == "PROTECTIVE_STOP" and input("Have you seen why it stopped? [yes] ") == "yes":
        robot.recover(tiller.Consent(cause_inspected=True), progress=print)
