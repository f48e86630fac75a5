# SPDX-License-Identifier: MIT
"""Force mode: compliant along Z with a force of 5 N for one second."""
import sys
import time

import tiller

with tiller.Robot(sys.argv[1]) as robot:
    robot.take_control()
    robot.zero_force_sensor()
    with robot.force_mode(compliant=[False, False, True, False, False, False], wrench=[0, 0, -5, 0, 0, 0],
                          limits=[0.05, 0.05, 0.02, 0.2, 0.2, 0.2]):
        time.sleep(1)
    print("force on the TCP [N]", robot.state.tcp_force[:3].round(1))
