# SPDX-License-Identifier: MIT
"""Sets an output, and reads it and an input."""
import sys

import tiller

with tiller.Robot(sys.argv[1]) as robot:
    robot.outputs.set_digital(0, True)  # returns when confirmed by the robot
    print("output 0", robot.state.digital_output(0), "input 0", robot.state.digital_input(0))
    robot.outputs.set_voltage(0, 5.0)
    robot.outputs.set_digital(0, False)
    print("output 0", robot.state.digital_output(0))
