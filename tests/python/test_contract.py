# SPDX-License-Identifier: MIT
"""The stop contract in Python. After a program was killed, suspended or disconnected, the arm must stop within 250 ms of
robot time and not move again by itself."""
import os
import signal
import subprocess
import sys
import time
import unittest

from robot import START, Robot, until
from rtde_receive import RTDEReceiveInterface

CONTRACT_MS = 250

# As in typical user programs, return values are ignored.
PROGRAMS = {
    "moveJ": "c.moveJ(turned(1.5), 0.4, 1.4, True)",
    "moveL": "c.moveL(lowered(0.3), 0.1, 0.5, True)",
    "path": "c.moveJ([turned(1.0) + [0.4, 1.4, 0.0], turned(-1.0) + [0.4, 1.4, 0.0]], True)",
    "speedJ": "loop(lambda t: c.speedJ([0.4, 0, 0, 0, 0, 0], 1.4))",
    "speedL": "loop(lambda t: c.speedL([0, 0, -0.1, 0, 0, 0], 0.5))",
    "servoJ": "loop(lambda t: c.servoJ(turned(0.3 * t), 0, 0, 0.004, 0.1, 300))",
    "servoL": "loop(lambda t: c.servoL(lowered(0.08 * t), 0, 0, 0.004, 0.1, 300))",
    "servoC": "loop(lambda t: c.servoC(lowered(0.3), 0.1, 0.5))",
    "jog": "c.jogStart([0, 0, -0.1, 0, 0, 0])",
    "moveUntilContact": "c.moveUntilContact([0, 0, -0.1, 0, 0, 0])",
    "forceMode": "c.forceMode([0] * 6, [0, 0, 1, 0, 0, 0], [0, 0, -10, 0, 0, 0], 2, [2, 2, 0.1, 1, 1, 1])",
}

PROGRAM = """
import sys, time
from rtde_control import RTDEControlInterface
START = {start}
c = RTDEControlInterface(sys.argv[1])
c.moveJ(START)
POSE = c.getForwardKinematics()
print("ready", flush=True)
def turned(angle):
    return [START[0] + angle] + START[1:]
def lowered(way):
    return POSE[:2] + [POSE[2] - way] + POSE[3:]
def loop(cycle):
    begin = time.monotonic()
    while True:
        cycle(time.monotonic() - begin)
        time.sleep(0.004)
{motion}
while True:
    time.sleep(1)
"""


class TestContract(unittest.TestCase):
    def check(self, name, end, again):
        receive = RTDEReceiveInterface(self.robot.host)
        program = PROGRAM.format(start=START, motion=PROGRAMS[name])
        process = subprocess.Popen([sys.executable, "-c", program, self.robot.host], stdout=subprocess.PIPE,
                                   stderr=subprocess.DEVNULL)
        try:
            process.stdout.readline()
            fast = 0.02 if name == "forceMode" else 0.04
            self.assertTrue(until(lambda: sum(v * v for v in receive.getActualTCPSpeed()[:3]) > fast * fast))
            end(process)
            milliseconds = float(self.robot.tell("still"))
            print(f"{self.id()} {name}: {milliseconds:.0f} ms", file=sys.stderr)
            self.assertLessEqual(milliseconds, CONTRACT_MS)
            again(process)
            time.sleep(0.3)
            self.assertLessEqual(float(self.robot.tell("still")), 50)
        finally:
            process.send_signal(signal.SIGCONT)
            process.kill()
            process.wait()
            process.stdout.close()
            receive.disconnect()

    def every(self, end, again=lambda process: None):
        for name in PROGRAMS:
            with self.subTest(name):
                self.robot = Robot("real")
                try:
                    self.check(name, end, again)
                finally:
                    self.robot.close()

    def test_kill(self):
        self.every(lambda process: process.kill())

    def test_suspend_and_resume(self):
        self.every(lambda process: process.send_signal(signal.SIGSTOP),
                   lambda process: process.send_signal(signal.SIGCONT))

    def test_cut_cable(self):
        self.every(lambda process: self.robot.tell("cut"), lambda process: self.robot.tell("join"))


if __name__ == "__main__":
    unittest.main()
