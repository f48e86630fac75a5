# SPDX-License-Identifier: MIT
"""Listings 2, 4 and 5 of the ur_rtde paper as printed, except for the address of the robot. Imported packages that
are not installed are replaced by small ones in listings/."""
import os
import runpy
import sys
import tempfile
import unittest

import numpy as np
from robot import START, Robot, moved, near, until
from rtde_control import RTDEControlInterface
from rtde_receive import RTDEReceiveInterface

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "listings")
sys.path.insert(0, FOLDER)


class TestListings(unittest.TestCase):
    def setUp(self):
        self.robot = Robot()
        self.receive = RTDEReceiveInterface(self.robot.host)
        self.folder = tempfile.TemporaryDirectory()
        self.before = os.getcwd()
        os.chdir(self.folder.name)

    def tearDown(self):
        os.chdir(self.before)
        self.folder.cleanup()
        self.receive.disconnect()
        self.robot.close()

    def run_listing(self, number):
        name = f"listing{number}.py"
        with open(os.path.join(FOLDER, name), encoding="utf-8") as file:
            text = file.read()
        self.assertIn('"localhost"', text)
        with open(name, "w", encoding="utf-8") as file:
            file.write(text.replace('"localhost"', f'"{self.robot.host}"'))
        result = runpy.run_path(name)
        result["rtde_c"].disconnect()
        return result

    def test_listing_2(self):
        self.run_listing(2)
        # This is a separate connection. Its data may be older than those of the connection that moved the arm.
        self.assertTrue(until(lambda: near(self.receive.getActualQ(), [0, 0.5, -0.5, 0.5, -0.5, 0.5])))

    def test_listing_4(self):
        time = np.arange(0, 1, 0.002)
        with open("demonstration.csv", "w", encoding="utf-8") as file:
            file.write("timestamp," + ",".join(f"actual_q_{i}" for i in range(6)) + "\n")
            for t in time:
                part = 10 * t ** 3 - 15 * t ** 4 + 6 * t ** 5
                row = moved(START, 0, 0.3 * part)
                file.write(",".join(repr(float(v)) for v in [100 + t] + row) + "\n")
        self.run_listing(4)
        self.assertTrue(until(lambda: near(self.receive.getActualQ(), moved(START, 0, 0.3), 0.02)))

    def test_listing_5(self):
        # Moves the arm to a position from which it can reach the first pose on a straight line.
        control = RTDEControlInterface(self.robot.host)
        self.assertTrue(control.moveJ_IK([0.36177, 0.10525, 0.6, 0, np.pi, 0]))
        control.disconnect()
        listing = self.run_listing(5)
        last = listing["p_i"]
        self.assertTrue(until(lambda: near(self.receive.getActualTCPPose()[:3], last[:3], 0.02)))


if __name__ == "__main__":
    unittest.main()
