# SPDX-License-Identifier: MIT
"""A demonstration is recorded, split and used for learning, as described in robot/examples/python/episodes."""
import importlib.util
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np

try:
    import h5py
except ImportError:
    h5py = None

SOURCE = os.environ["TILLER_SOURCE"]
EXAMPLE = os.path.join(SOURCE, "robot", "examples", "python", "episodes", "learn_and_repeat.py")
CLI = os.environ.get("TILLER_CLI", "")


@unittest.skipIf(h5py is None, "h5py is not installed (python3-h5py)")
class TestEpisodes(unittest.TestCase):
    def example(self):
        spec = importlib.util.spec_from_file_location("learn_and_repeat", EXAMPLE)
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        return module

    def test_the_primitive_follows_the_demonstrated_path(self):
        """Uses a path to the goal and half of the way back, which a spring alone cannot produce."""
        primitive = self.example().MovementPrimitive()
        t = np.linspace(0, 1, 501)[:, None]
        bend = np.sin(np.pi * t ** 2) ** 4 * [0.5, 0, 0, 0.2, 0, -0.1]
        demo = np.array([0.1, -1, 1, 0, 0.5, 0]) + (10 * t ** 3 - 15 * t ** 4 + 6 * t ** 5) * 0.4 + bend
        primitive.learn([demo], 0.01)
        way = primitive.way_from(demo[0], 0.01, settle=0)
        self.assertLess(np.abs(way - demo[1:]).max(), 0.03)
        # From another start, the path must reach the same end.
        other = primitive.way_from(demo[0] + 0.2, 0.01, settle=2)
        self.assertLess(np.abs(other[-1] - demo[-1]).max(), 0.01)

    @unittest.skipUnless(CLI and os.path.exists(CLI), "tiller-cli was not built")
    def test_from_the_robot_and_back_to_it(self):
        import tiller

        with tempfile.TemporaryDirectory() as folder, tiller.Simulator() as simulator:
            recording = os.path.join(folder, "demo.mcap")
            episodes = os.path.join(folder, "demos.h5")
            recorder = subprocess.Popen([CLI, "record", simulator.address, "--out", recording, "--quiet"])
            try:
                with tiller.Robot(simulator.address) as robot:
                    robot.take_control()
                    start = robot.state.q
                    robot.move_j(start + [0.3, -0.1, 0.2, 0, 0, 0.1], speed=0.5).wait()
                    end = robot.state.q
                    robot.move_j(start, speed=1).wait()
            finally:
                recorder.terminate()
                self.assertEqual(recorder.wait(timeout=60), 0)
            cut = subprocess.run([CLI, "episodes", recording, "--out", episodes, "--rate", "50", "--cut", "program"],
                                 capture_output=True, text=True, check=False)
            self.assertEqual(cut.returncode, 0, cut.stderr)
            with h5py.File(episodes) as file:
                demo = file["data/demo_0/obs/actual_q"][:]
            self.assertLess(np.abs(demo - end).max(axis=1).min(), 0.01)
            learned = subprocess.run([sys.executable, "-B", EXAMPLE, simulator.address, episodes, "--rate", "50"],
                                     capture_output=True, text=True, check=False, timeout=120)
            self.assertEqual(learned.returncode, 0, learned.stderr)
            self.assertIn("learned from", learned.stdout)
            self.assertIn("cycles", learned.stdout)
            with tiller.Robot(simulator.address) as robot:
                self.assertLess(np.abs(robot.state.q - demo[-1]).max(), 0.03)


if __name__ == "__main__":
    unittest.main()
