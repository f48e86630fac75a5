# SPDX-License-Identifier: MIT
"""Records two seconds to a CSV file with one row per packet, and evaluates it with pandas."""
import sys
import time

import tiller

with tiller.Robot(sys.argv[1]) as robot:
    with robot.record("recording.csv", ["actual_q", "actual_TCP_force"]) as recording:
        time.sleep(2)
    frame = recording.frame()
    print(len(frame), "rows,", frame.packages_lost.sum(), "packets lost")
    print(frame.actual_TCP_force_2.describe())
