# SPDX-License-Identifier: MIT
"""Moves there and back: in joint space, then along a line."""
import sys

import tiller

with tiller.Robot(sys.argv[1]) as robot:
    robot.take_control()
    start = robot.state.q
    robot.move_j(start + [0, 0, 0, 0, 0, 0.3], speed=0.5).wait()  # rad, rad/s
    up = robot.state.tcp_pose
    up[2] += 0.05
    move = robot.move_l(up, speed=0.1)  # m/s; returns immediately, the arm moves to its target
    move.wait(timeout=10)
    print("moved", move.progress.fraction, "of the way, ended by", move.cause)
    robot.move_j(start).wait()
