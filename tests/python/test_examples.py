# SPDX-License-Identifier: MIT
"""The examples of robot/examples/python run unchanged, each with its own simulated robots."""
import ast
import os
import subprocess
import sys
import tempfile
import unittest

import tiller

FOLDER = os.path.join(os.environ["TILLER_SOURCE"], "robot", "examples", "python")
SAYS = {"read": "RUNNING", "record": "rows, 0 packets lost", "move_and_wait": "ended by Completed", "jog": "rose ",
        "servo_circle": "cycles", "force": "force on the TCP", "outputs": "output 0 True", "several_robots": "is back",
        "recover": "RUNNING NORMAL", "simulate": "PROTECTIVE_STOP", "drop_in": "[", "coroutines": "fastest 0.", "collisions": "table",
        "program": "completed "}
# If the computer is blocked for 100 ms, a held motion ends as intended.
LATE = ("LinkLost", "EventLoopStalled", "DataStale", "Timeout", "not refreshed")
ATTEMPTS = 5


class TestExamples(unittest.TestCase):
    def test_the_examples_are_short(self):
        names = sorted(name[:-3] for name in os.listdir(FOLDER) if name.endswith(".py"))
        self.assertEqual(names, sorted(SAYS))
        for name in names:
            with open(os.path.join(FOLDER, name + ".py"), encoding="utf-8") as file:
                text = file.read()
            self.assertLess(len(text.splitlines()), 31, name)
            self.assertTrue(ast.get_docstring(ast.parse(text)), name)

    def test_each_example_runs(self):
        for name, said in SAYS.items():
            with self.subTest(name), tempfile.TemporaryDirectory() as folder, tiller.Simulator() as one, \
                    tiller.Simulator() as other:
                addresses = [one.address] + ([other.address] if name == "several_robots" else [])
                for _ in range(ATTEMPTS):
                    result = subprocess.run([sys.executable, "-B", os.path.join(FOLDER, name + ".py"), *addresses],
                                            cwd=folder, text=True, capture_output=True, check=False, timeout=120)
                    if not any(word in result.stderr for word in LATE):
                        break
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertIn(said, result.stdout)


if __name__ == "__main__":
    unittest.main()
