# SPDX-License-Identifier: MIT
"""Reads joint positions and TCP pose once, and then every packet for a short time."""
import sys

import tiller

with tiller.Robot(sys.argv[1]) as robot:
    q, pose = robot.snapshot("actual_q", "actual_TCP_pose")  # from one packet
    print("joints [rad]", q.round(4), "TCP [m, rad]", pose.round(4))
    for sample in robot.samples():  # every packet once, up to 500 per second
        if sample.sequence % 100 == 0:
            print(f"{sample.time:.3f} s", sample.robot_mode, sample.tcp_force.round(2))
        if sample.sequence >= 500:
            break
