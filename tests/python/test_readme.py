# SPDX-License-Identifier: MIT
"""The Python example of the README, unchanged, with the controller simulated by tiller-cli."""
import os
import re
import subprocess
import sys
import unittest


class TestReadme(unittest.TestCase):
    def setUp(self):
        pid = os.getpid()
        self.host = f"127.{10 + pid % 200}.{pid // 200 % 250}.7"
        self.simulator = subprocess.Popen([os.environ["TILLER_CLI"], "simulate", "--headless", "--listen", self.host],
                                          stdout=subprocess.PIPE, text=True)
        self.assertTrue(self.simulator.stdout.readline().startswith("ready "))

    def tearDown(self):
        self.simulator.terminate()
        self.simulator.wait()
        self.simulator.stdout.close()

    def test_the_example_runs(self):
        with open(os.environ["TILLER_README"], encoding="utf-8") as file:
            examples = re.findall(r"```python\n(.*?)```", file.read(), re.DOTALL)
        self.assertEqual(len(examples), 2)
        ran = subprocess.run([sys.executable, "-c", examples[1], self.host], capture_output=True, text=True)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        pose = [float(number) for number in ran.stdout.strip().strip("[]").split(",")]
        self.assertEqual(len(pose), 6)
        self.assertLess(sum(x * x for x in pose[:3]), 1.5 ** 2)  # [m]; within the reach of the arm
        # tests/integration/examples checks that both code blocks are contained in robot/examples, and test_examples
        # runs the other one.


if __name__ == "__main__":
    unittest.main()
