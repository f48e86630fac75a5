# SPDX-License-Identifier: MIT
"""Moves the tool in a circle of 3 cm, with one target per packet."""
import math
import sys

import tiller

with tiller.Robot(sys.argv[1]) as robot:
    robot.take_control()
    centre = robot.state.tcp_pose - [0.03, 0, 0, 0, 0, 0]

    def circle(cycle):
        angle = math.pi * cycle.time
        if angle > 2 * math.pi:
            return None  # ends the loop, and the arm stops
        return centre + [0.03 * math.cos(angle), 0.03 * math.sin(angle), 0, 0, 0, 0]

    report = robot.packet_loop("servo_l", circle)
    print(report.cycles, "cycles,", report.missed, "missed, longest call", round(1000 * report.longest_call, 2), "ms")
