# SPDX-License-Identifier: MIT
# Listing 2 of the ur_rtde paper.
from rtde_control import RTDEControlInterface
rtde_c = RTDEControlInterface(ip="localhost")
joint_pos = [0, 0.5, -0.5, 0.5, -0.5, 0.5]
rtde_c.moveJ(joint_pos, vel=1.05, acc=1.4)
