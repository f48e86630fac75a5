# SPDX-License-Identifier: MIT
"""Jogs the tool upwards for one second by refreshing the jog."""
import sys
import time

import tiller

with tiller.Robot(sys.argv[1]) as robot:
    robot.take_control()
    before = robot.state.tcp_pose[2]
    with robot.jog([0, 0, 0.05, 0, 0, 0]) as jog:  # m/s in the base frame
        for _ in range(50):
            time.sleep(0.02)
            if not jog.refresh():  # at least every 100 ms, otherwise the arm stops
                raise SystemExit(f"the jog ended: {jog.cause}")
    print(f"rose {1000 * (robot.state.tcp_pose[2] - before):.0f} mm")
