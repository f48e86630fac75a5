# SPDX-License-Identifier: MIT
"""The Python code of robot/PROGRAMMING.md, step by step, with the simulated controller."""
import os
import pathlib
import re
import tempfile
import unittest

import tiller


class TestTutorial(unittest.TestCase):
    def test_all_steps_run(self):
        page = pathlib.Path(os.environ["TILLER_SOURCE"], "robot", "PROGRAMMING.md").read_text(encoding="utf-8")
        steps = re.findall(r"```python\n(.*?)```", page, flags=re.DOTALL)
        self.assertEqual(len(steps), 6)
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder, tiller.Simulator() as simulator:
            os.chdir(folder)
            try:
                names = {"address": simulator.address, "print": lambda *values: None}
                for number, step in enumerate(steps, 1):
                    exec(compile(step, f"step {number}", "exec"), names)  # pylint: disable=exec-used
                self.assertGreater(len(names["frame"]), 10)
                self.assertEqual(names["frame"].filter(like="actual_q_").shape[1], 6)
            finally:
                os.chdir(before)


if __name__ == "__main__":
    unittest.main()
