# SPDX-License-Identifier: MIT
"""Examines moves for collisions before they are executed, and lets jogs end before a table."""
import sys

import tiller
from tiller.collision import Box, CollisionCheck, Plane

with tiller.Robot(sys.argv[1]) as robot:
    height = robot.state.tcp_pose[2]
    table = Plane([0, 0, height - 0.1, 0, 0, 0], name="table")  # the arm stays above it
    check = CollisionCheck("UR5e", planes=[table], boxes=[Box([0.6, 0.3, height, 0, 0, 0], [0.1, 0.1, 0.3], name="pillar")])
    q = robot.state.q
    for target in (q + [0.2, 0, 0, 0, 0, 0], q - [0, 0.6, 0, 0, 0, 0]):
        report = check.examine(q, target)
        print("blocked by" if report.blocked else "free", report.contact.other if report.contact else report.limit or "")
    robot.take_control()
    robot.set_collision_check(check)
    robot.jog_while(lambda sample: [0, 0, -0.1, 0, 0, 0])  # ends at the safety distance
    print(f"{1000 * (robot.state.tcp_pose[2] - height + 0.1):.0f} mm above the table")
