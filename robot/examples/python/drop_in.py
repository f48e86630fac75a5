# SPDX-License-Identifier: MIT
"""An unchanged program written for ur_rtde: the modules have the same names."""
import sys

import rtde_control
import rtde_receive

control = rtde_control.RTDEControlInterface(sys.argv[1])
receive = rtde_receive.RTDEReceiveInterface(sys.argv[1])
q = receive.getActualQ()
control.moveJ([q[0] + 0.1, *q[1:]], 0.5, 0.5)  # rad, rad/s, rad/s^2
print(receive.getActualTCPPose())  # m and rotation vector, base frame
control.stopScript()
